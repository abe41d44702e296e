// The reader of the command-line program: of any bytes it makes a mesh that geodesic_remeshing() takes, or an
// Input_error. The first byte tells the format, and whether to repair and to stitch.

#include "input.h"

#include <CGAL/boost/graph/helpers.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::string folder = std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp";
  static const std::string name = folder + "/geodesic_remesh_fuzz." + std::to_string(getpid());
  static const char* const formats[] = {"off", "obj", "ply", "stl", "ts"};
  if(size < 2)
    return 0;
  std::ofstream(name, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  try
  {
    const command_line::Input_file file(name, formats[data[0] % 5]);
    command_line::Repair_options options;
    options.do_repair = (data[0] & 64) == 0;
    options.stitch_tolerance = (data[0] & 128) == 0 ? 0. : .1;
    options.fill_holes = (data[0] & 32) == 0 ? 0 : 6;
    options.drop_parts = (data[0] & 16) == 0 ? 0. : 10.;
    const auto input = command_line::read_mesh(file, options);
    if(!CGAL::is_valid_polygon_mesh(input.mesh) || !CGAL::is_triangle_mesh(input.mesh))
      std::abort();
  }
  catch(const command_line::Input_error&)
  {}
  return 0;
}
