// What people expect of a program in a terminal: help, man page, completion, standard streams, colors, a documented
// report.

#include "command_line_support.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <pty.h>

namespace {

using namespace command_line_support;

bool is_installed(const std::string& command)
{
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

// The names of the options that --help lists
std::set<std::string> options_of_help(const std::string& help)
{
  std::set<std::string> options;
  std::istringstream lines(help);
  for(std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if(word.size() == 3 && word[0] == '-' && word[2] == ',')
      words >> word;
    if(line.rfind("  -", 0) == 0)
      options.insert(word);
  }
  return options;
}

// What the program writes to a terminal
std::string on_terminal(const std::string& settings, const std::string& arguments)
{
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if(child == 0)
  {
    const std::string command =
        "env -u NO_COLOR TERM=xterm " + settings + " '" GEODESIC_REMESH_PROGRAM "' " + arguments;
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  std::string written;
  std::array<char, 4096> buffer{};
  for(ssize_t size = 0; (size = read(terminal, buffer.data(), buffer.size())) > 0;)
    written.append(buffer.data(), static_cast<std::size_t>(size));
  close(terminal);
  waitpid(child, nullptr, 0);
  return written;
}

// What the page of --html has to show
nlohmann::json data_of_page(const std::string& page)
{
  const std::string start = "<script id=\"data\" type=\"application/json\">";
  const std::size_t from = page.find(start) + start.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

std::size_t bytes_of_base64(const std::string& text)
{
  return text.size() / 4 * 3 - (text.empty() ? 0 : (text[text.size() - 1] == '=') + (text[text.size() - 2] == '='));
}

std::size_t sum_of(const nlohmann::json& numbers)
{
  std::size_t sum = 0;
  for(const std::size_t n : numbers)
    sum += n;
  return sum;
}

std::string installed_browser()
{
  for(const char* name : {"chromium", "chromium-browser", "google-chrome"})
    if(is_installed(std::string("command -v ") + name))
      return name;
  return {};
}

} // namespace

TEST_F(Command_line, help_lists_the_options_in_groups)
{
  const Outcome help = run("--help");
  EXPECT_EQ(help.status, 0);
  const auto options = options_of_help(help.out);
  for(const char* option :
      {"--vertices", "--faces", "--edge-length", "--contrast", "--report", "--quiet", "--help", "--version"})
    EXPECT_EQ(options.count(option), 1u) << option;
  for(const char* heading : {"\nTarget", "\nSizing:", "\nInput:", "\nOutput:", "\nExamples:", "\nExit status:"})
    EXPECT_NE(help.out.find(heading), std::string::npos) << heading;
  std::istringstream lines(help.out);
  for(std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 110u) << line;
  EXPECT_EQ(run("-h").out, help.out);
}

TEST_F(Command_line, version_names_the_library_as_well)
{
  const Outcome version = run("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.rfind("geodesic_remesh ", 0), 0u);
  EXPECT_NE(version.out.find("CGAL"), std::string::npos);
}

TEST_F(Command_line, man_page_has_every_option)
{
  const Outcome page = run("--generate man");
  ASSERT_EQ(page.status, 0);
  for(const std::string& option : options_of_help(run("--help").out))
  {
    std::string roff;
    for(const char c : option)
      roff += c == '-' ? std::string("\\-") : std::string(1, c);
    EXPECT_NE(page.out.find(roff + "\\fR"), std::string::npos) << option;
  }
  expect_failure("--generate poem", 1, "one of man|complete-bash|complete-zsh");
}

TEST_F(Command_line, man_page_is_well_formed)
{
  if(!is_installed("command -v mandoc"))
    GTEST_SKIP() << "mandoc is not installed";
  const std::string page = file("geodesic_remesh.1", run("--generate man").out);
  const std::string lint = (folder / "lint").string();
  EXPECT_TRUE(is_installed("mandoc -T lint -W error '" + page + "'"));
  EXPECT_EQ(std::system(("mandoc -T utf8 '" + page + "' | col -b >'" + lint + "'").c_str()), 0);
  EXPECT_NE(contents(lint).find("--edge-length L"), std::string::npos);
}

TEST_F(Command_line, bash_completes_options_and_their_values)
{
  if(!is_installed("command -v bash"))
    GTEST_SKIP() << "bash is not installed";
  const std::string completion = file("completion", run("--generate complete-bash").out);
  const auto complete = [&](const std::string& words, int current) {
    const std::string script =
        file("script", ". '" + completion + "'\nCOMP_WORDS=(" + words + ")\nCOMP_CWORD=" + std::to_string(current) +
                           "\n_geodesic_remesh\necho \"${COMPREPLY[@]}\"\n");
    EXPECT_EQ(std::system(("cd '" + folder.string() + "' && bash '" + script + "' >answer").c_str()), 0);
    return contents(folder / "answer");
  };
  file("mesh.off", "");
  EXPECT_EQ(complete("geodesic_remesh --ver", 1), "--vertices --version\n");
  EXPECT_EQ(complete("geodesic_remesh mes", 1), "mesh.off\n");
  EXPECT_EQ(complete("geodesic_remesh a b --output-format o", 4), "off obj\n");
  EXPECT_EQ(complete("geodesic_remesh a b --sizing mes", 4), "mesh.off\n");
  EXPECT_EQ(complete("geodesic_remesh a b --vertices mes", 4), "\n");
}

TEST_F(Command_line, zsh_completion_has_every_option)
{
  const std::string completion = run("--generate complete-zsh").out;
  EXPECT_EQ(completion.rfind("#compdef geodesic_remesh\n", 0), 0u);
  for(const std::string& option : options_of_help(run("--help").out))
    EXPECT_TRUE(completion.find("'" + option + "[") != std::string::npos ||
                completion.find("," + option + "}'[") != std::string::npos)
        << option;
  if(!is_installed("command -v zsh"))
    GTEST_SKIP() << "zsh is not installed, so that nobody has parsed the completion";
  EXPECT_TRUE(is_installed("zsh -n '" + file("_geodesic_remesh", completion) + "'"));
}

TEST_F(Command_line, standard_input_and_standard_output)
{
  const Outcome through = run("- - --input-format off --vertices 300 <" + mesh("eight"));
  EXPECT_EQ(through.status, 0) << through.err;
  EXPECT_NE(through.err.find("Hausdorff"), std::string::npos); // the table makes way for the mesh
  ASSERT_EQ(run(mesh("eight") + " " + output() + " --vertices 300").status, 0);
  EXPECT_EQ(through.out, contents(output()));

  const Outcome as_ply = run(mesh("eight") + " - --output-format ply --vertices 300 --quiet");
  EXPECT_EQ(as_ply.out.rfind("ply\n", 0), 0u);
  EXPECT_EQ(as_ply.err, "");
  file("piped.ply", as_ply.out);
  EXPECT_EQ(
      run("- " + output("again.off") + " --input-format ply --vertices 200 <'" + (folder / "piped.ply").string() + "'")
          .status,
      0);
  EXPECT_EQ(vertices_and_faces_of_off(output("again.off"))[0], 200u);
}

TEST_F(Command_line, report_to_standard_output)
{
  const Outcome outcome = run(mesh("eight") + " " + output() + " --vertices 300 --quiet --report -");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("{\n", 0), 0u);
  EXPECT_EQ(vertices_and_faces_of_off(output())[0], 300u);
}

TEST_F(Command_line, format_that_is_told_wins_over_the_ending)
{
  const std::string input = file("mesh.dat", contents(mesh("eight")));
  EXPECT_EQ(
      run(input + " " + output("mesh.stl") + " --input-format off --output-format obj --vertices 300 --quiet").status,
      0);
  EXPECT_NE(contents(output("mesh.stl")).find("\nv "), std::string::npos);
}

TEST_F(Command_line, wrong_use_of_streams_and_formats)
{
  expect_failure("- " + output() + " --vertices 100 </dev/null", 1, "--input-format");
  expect_failure("- " + output() + " --input-format off --vertices 100 </dev/null", 2, "standard input");
  expect_failure(mesh("eight") + " - --report - --vertices 100", 1, "twice");
  expect_failure(mesh("eight") + " " + output() + " --output-format doc --vertices 100", 1, "one of off|obj");
  const std::string full =
      "'" GEODESIC_REMESH_PROGRAM "' '" + mesh("eight") + "' - --vertices 100 >/dev/full 2>'" + output() + "'";
  EXPECT_EQ(WEXITSTATUS(std::system(full.c_str())), 3);
  EXPECT_EQ(contents(output()), "geodesic_remesh: standard output cannot be written\n");
}

TEST_F(Command_line, errors_have_colors_on_a_terminal_only)
{
  const std::string red = "\033[1;31m";
  const std::string wrong = "missing.off '" + output() + "' --vertices 100";
  EXPECT_NE(on_terminal("", wrong).find(red), std::string::npos);
  EXPECT_EQ(on_terminal("NO_COLOR=1", wrong).find('\033'), std::string::npos);
  EXPECT_NE(on_terminal("NO_COLOR=", wrong).find(red), std::string::npos); // empty: as if it were not set
  EXPECT_EQ(on_terminal("TERM=dumb", wrong).find('\033'), std::string::npos);
  EXPECT_EQ(run(wrong).err.find('\033'), std::string::npos);
}

TEST_F(Command_line, progress_is_shown_on_a_terminal_only)
{
  const std::string usual = "'" + mesh("eight") + "' '" + output() + "' --vertices 300";
  EXPECT_NE(on_terminal("", usual).find("improvement"), std::string::npos);
  EXPECT_EQ(on_terminal("", usual + " --quiet"), "");
  EXPECT_EQ(on_terminal("TERM=dumb", usual).find("improvement"), std::string::npos);
  EXPECT_EQ(run(usual).err, "");
}

TEST_F(Command_line, report_follows_its_schema)
{
  const std::string python = is_installed("python3 -c 'import jsonschema'")            ? "python3"
                             : is_installed("/usr/bin/python3 -c 'import jsonschema'") ? "/usr/bin/python3"
                                                                                       : "";
  if(python.empty())
    GTEST_SKIP() << "Python's package jsonschema is not installed";
  const std::string script =
      file("validate.py", "import json, sys, jsonschema\n"
                          "schema = json.load(open(sys.argv[1]))\n"
                          "jsonschema.Draft202012Validator.check_schema(schema)\n"
                          "jsonschema.Draft202012Validator(schema).validate(json.load(open(sys.argv[2])))\n");
  const auto is_valid = [&](const std::string& report) {
    return std::system((python + " '" + script + "' '" REPORT_SCHEMA "' '" + report + "' 2>/dev/null").c_str()) == 0;
  };
  const std::string usual = mesh("eight") + " " + output() + " --vertices 300 --quiet --report " + output("r.json");
  ASSERT_EQ(run(usual).status, 0);
  EXPECT_TRUE(is_valid(output("r.json")));
  ASSERT_EQ(run(usual + " --check --contrast 0.5").status, 0);
  EXPECT_TRUE(is_valid(output("r.json")));
  EXPECT_FALSE(is_valid(file("other.json", "{\"version\": \"0\"}")));
}

TEST_F(Command_line, page_holds_both_meshes_and_the_report)
{
  const Outcome outcome = run(mesh("eight") + " " + output() + " --vertices 500 --quiet --html " + output("o.html") +
                              " --report " + output("r.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto data = data_of_page(contents(output("o.html")));
  EXPECT_EQ(data["report"], nlohmann::json::parse(contents(output("r.json"))));
  EXPECT_EQ(data["title"], "eight.off");
  for(const char* side : {"input", "output"})
  {
    const auto& shown = data["meshes"][side];
    const std::size_t vertices = data["report"][side]["vertices"], faces = data["report"][side]["faces"];
    EXPECT_EQ(shown["shown"], faces) << side;
    EXPECT_EQ(bytes_of_base64(shown["positions"]), 12 * vertices) << side;
    EXPECT_EQ(bytes_of_base64(shown["indices"]), 12 * faces) << side;
    EXPECT_EQ(bytes_of_base64(shown["valence"]), vertices) << side;
    for(const char* values : {"angle", "quality", "deviation"})
      EXPECT_EQ(bytes_of_base64(shown[values]), faces) << side << " " << values;
    EXPECT_EQ(sum_of(data["histograms"]["angles"][side]), 3 * faces) << side;
    EXPECT_EQ(sum_of(data["histograms"]["valences"][side]), vertices) << side; // no boundary
  }
  EXPECT_EQ(bytes_of_base64(data["meshes"]["output"]["region"]),
            2 * data["report"]["output"]["faces"].get<std::size_t>());
  EXPECT_EQ(bytes_of_base64(data["curves"]["sizes"]), 4 * data["report"]["curves"].get<std::size_t>());
}

TEST_F(Command_line, page_needs_no_network_and_no_name_breaks_it)
{
  fs::create_directory(folder / "<");
  const std::string input = file("</script><b>.off", contents(mesh("eight")));
  ASSERT_EQ(run("'" + input + "' " + output() + " --vertices 300 --quiet --html " + output("o.html")).status, 0);
  const std::string page = contents(output("o.html"));
  EXPECT_EQ(data_of_page(page)["title"], "script><b>.off"); // what follows the last slash
  for(const char* reference : {" src=", "@import", "<b>", "fetch(\"http"})
    EXPECT_EQ(page.find(reference), std::string::npos) << reference;
}

TEST_F(Command_line, page_draws_all_faces_in_a_browser)
{
  const std::string browser = installed_browser();
  if(browser.empty())
    GTEST_SKIP() << "no Chromium is installed";
  ASSERT_EQ(run(mesh("eight") + " " + output() + " --vertices 500 --quiet --html " + output("o.html")).status, 0);
  const auto drawn = [&](const std::string& view) {
    const std::string command =
        "timeout 120 " + browser + " --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader " +
        "--user-data-dir='" + (folder / "profile").string() + "' --virtual-time-budget=3000 --dump-dom 'file://" +
        output("o.html") + view + "' >'" + (folder / "dom").string() + "' 2>/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0);
    const std::string dom = contents(folder / "dom"), attribute = "data-drawn=\"";
    const std::size_t at = dom.find(attribute);
    return at == std::string::npos
               ? "nothing"
               : dom.substr(at + attribute.size(), dom.find('"', at + attribute.size()) - at - attribute.size());
  };
  const auto faces = vertices_and_faces_of_off(mesh("eight"))[1];
  EXPECT_EQ(drawn(""), std::to_string(faces) + " 1004");
  const auto regions = data_of_page(contents(output("o.html")))["meshes"]["regions"]["faces"].get<std::size_t>();
  EXPECT_EQ(drawn("#color=regions"), std::to_string(regions) + " 1004");
}

#ifdef NDEBUG // takes too long with checks
TEST_F(Command_line, page_of_a_large_mesh_draws_fewer_faces)
{
  ASSERT_EQ(run(mesh("eight") + " " + output() + " --vertices 126000 --quiet --html " + output("o.html")).status, 0);
  const auto data = data_of_page(contents(output("o.html")));
  const std::size_t faces = data["report"]["output"]["faces"], shown = data["meshes"]["output"]["shown"];
  EXPECT_EQ(faces, 252004u);
  EXPECT_LE(shown, 250000u);
  EXPECT_GT(shown, 60000u);
  EXPECT_EQ(bytes_of_base64(data["meshes"]["output"]["indices"]), 12 * shown);
  EXPECT_EQ(sum_of(data["histograms"]["angles"]["output"]), 3 * faces); // of all
}
#endif

// A folder of models, one of them damaged, and a program that remeshes them all
class Folder_of_models : public Command_line
{
protected:
  void SetUp() override
  {
    Command_line::SetUp();
    fs::create_directory(folder / "models");
    for(const char* name : {"eight", "cube"})
      fs::copy_file(mesh(name), folder / "models" / (std::string(name) + ".off"));
    fs::copy_file(mesh("eight"), folder / "models" / "an eight's \"copy\".off");
    file("models/damaged.off", "no mesh");
    file("models/notes.txt", "no mesh either");
  }

  // The exit status; what is written to standard error is in `said`
  int run_on_models(const std::string& program, const std::string& options = "")
  {
    const std::string command = program + " '" + (folder / "models").string() + "' '" + (folder / "written").string() +
                                "' --vertices 300" + options + " >/dev/null 2>'" + (folder / "said").string() + "'";
    const int status = WEXITSTATUS(std::system(command.c_str()));
    said = contents(folder / "said");
    return status;
  }

  void expect_all_but_the_damaged() const
  {
    for(const char* name : {"eight.off", "cube.off", "an eight's \"copy\".off"})
    {
      EXPECT_EQ(vertices_and_faces_of_off(output(std::string(name) + ".off"))[0], 300u) << name;
      const auto report = nlohmann::json::parse(contents(output(std::string(name) + ".json")));
      EXPECT_EQ(report["output"]["vertices"], 300) << name;
    }
    EXPECT_FALSE(fs::exists(output("damaged.off.off")));
    EXPECT_FALSE(fs::exists(output("notes.txt.off")));
    EXPECT_NE(said.find("damaged.off: geodesic_remesh:"), std::string::npos) << said;
    EXPECT_NE(said.find("3 models remeshed, 1 failed"), std::string::npos) << said;
  }

  std::string said;
};

#ifdef FOLDER_PROGRAM
TEST_F(Folder_of_models, remeshed_and_gone_on_with)
{
  EXPECT_EQ(run_on_models(FOLDER_PROGRAM), 1);
  expect_all_but_the_damaged();
  fs::remove(output("cube.off.off"));
  const auto before = fs::last_write_time(output("eight.off.off"));
  fs::copy_file(mesh("cube"), folder / "models" / "damaged.off", fs::copy_options::overwrite_existing);
  EXPECT_EQ(run_on_models(FOLDER_PROGRAM), 0) << said; // only what is missing
  EXPECT_NE(said.find("2 models remeshed, 0 failed"), std::string::npos) << said;
  EXPECT_EQ(fs::last_write_time(output("eight.off.off")), before);
  EXPECT_EQ(vertices_and_faces_of_off(output("damaged.off.off"))[0], 300u);
  EXPECT_FALSE(fs::exists(output("damaged.off.log")));
}

// By a stand-in for the program beside it, which writes a result that the check finds a fault in
TEST_F(Folder_of_models, results_that_are_not_valid_are_made_again)
{
  const fs::path program = folder / "geodesic_remesh_folder";
  fs::copy_file(FOLDER_PROGRAM, program);
  const std::string stand_in = file("geodesic_remesh", "#!/bin/sh\necho OFF >\"$2\"\nexit 4\n");
  fs::permissions(stand_in, fs::perms::owner_all);
  for(const char* format : {" --output-format=ply", " --output-format ply"})
    for(int round = 0; round < 2; ++round)
    {
      EXPECT_EQ(run_on_models("'" + program.string() + "'", format), 1);
      EXPECT_NE(said.find("cube.off: the check found a fault"), std::string::npos) << said;
      EXPECT_NE(said.find("0 models remeshed, 4 failed"), std::string::npos) << said;
      EXPECT_TRUE(fs::exists(output("cube.off.ply")));
    }
}

TEST_F(Folder_of_models, wrong_use_of_folders)
{
  EXPECT_EQ(WEXITSTATUS(std::system(FOLDER_PROGRAM " a b 2>/dev/null")), 1);
  EXPECT_EQ(WEXITSTATUS(std::system(FOLDER_PROGRAM " /no/such/folder . --vertices 100 2>/dev/null")), 1);
  EXPECT_EQ(
      WEXITSTATUS(std::system(
          ("cd '" + folder.string() + "' && '" FOLDER_PROGRAM "' models ./models --vertices 100 2>/dev/null").c_str())),
      1);
  EXPECT_TRUE(fs::is_empty(folder / "written"));
}
#endif

#ifdef FOLDER_MPI_PROGRAM
TEST_F(Folder_of_models, remeshed_by_processes_of_mpi)
{
  // containers are often root and have fewer processors than this asks for
  const std::string settings =
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 ";
  EXPECT_EQ(run_on_models(settings + MPIEXEC " 3 '" FOLDER_MPI_PROGRAM "'"), 1);
  expect_all_but_the_damaged();
}
#endif

// As the manual shows it
TEST_F(Folder_of_models, remeshed_by_gnu_parallel)
{
  if(!is_installed("parallel --version | grep GNU"))
    GTEST_SKIP() << "GNU parallel is not installed";
  const std::string command = "cd '" + folder.string() +
                              "' && parallel --joblog jobs --resume-failed '" GEODESIC_REMESH_PROGRAM
                              "' {} written/{/}.off --vertices 300 --quiet ::: models/*.off 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1); // the number of those that failed
  for(const char* name : {"eight.off.off", "cube.off.off", "an eight's \"copy\".off.off"})
    EXPECT_EQ(vertices_and_faces_of_off(output(name))[0], 300u) << name;
}
