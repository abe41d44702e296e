# What README and manual tell others to write, as they stand there:
#
#   awk -v language=cmake -f snippets.awk README.md manual.txt ...   all blocks of code in CMake's language
#   awk -v language=cpp -f snippets.awk README.md manual.txt ...     one header of all blocks in C++: the program as it is but
#     for the name of main(), each of the others a function that has a mesh and an output
function is_end() { return /^```/ || /^\\endcode/ }
inside && is_end() {
  inside = 0
  if(language == "cpp")
    after = after (is_program ? text : "inline void snippet_" ++snippets "(Mesh& mesh, Mesh& out)\n{\n" text "}\n\n")
  else
    after = after text
  next
}
inside && language == "cpp" && /^#include/ { before = before $0 "\n"; next }
inside {
  if(sub(/int main\(\)/, "inline void program_of_readme()"))
    is_program = 1
  text = text $0 "\n"
}
$0 == "```" language || $0 == "\\code{." language "}" { inside = 1; is_program = 0; text = "" }
END { printf "%s\n%s", before, after }
