# An OFF file (text) as OBJ, for programs that read only the latter.
{ sub(/#.*/, "") }
NF == 0 { next }
!header { header = 1; if ($0 ~ /^[A-Z]*OFF/) { sub(/^[A-Z]*OFF/, ""); if (NF == 0) next } }
vertices == "" { vertices = $1; next }
seen < vertices { ++seen; print "v", $1, $2, $3; next }
{ line = "f"; for (i = 2; i <= $1 + 1; ++i) line = line " " ($i + 1); print line }
