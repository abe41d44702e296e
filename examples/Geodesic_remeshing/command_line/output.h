// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OUTPUT_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OUTPUT_H

#include "../include/mesh_quality.h"
#include "interruption.h"
#include "options.h"
#include "system.h"

#include <CGAL/Surface_mesh/IO.h>
#include <CGAL/boost/graph/IO/GOCAD.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace command_line {

// exit status 3
struct Output_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// The files of one run: each is written beside its place under another name, and all are put into their places at the
// end, so that nobody ever sees half a file, nor files of a run that failed.
class Output_files
{
public:
  Output_files() = default;
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  ~Output_files()
  {
    std::error_code ignored;
    for(const auto& file : m_files)
      std::filesystem::remove(file.temporary, ignored);
  }

  // Called before the work begins: fails at once if the place cannot be written to.
  void announce(const std::string& name)
  {
    namespace fs = std::filesystem;
    const fs::path place(name), target = name == "-" ? fs::path() : target_of(place);
    for(const auto& file : m_files)
      if(file.target == target)
        throw Usage_error(name + " is asked for twice");
    if(name == "-")
    {
      m_files.push_back({place, {}, {}});
      return;
    }
    std::error_code error;
    // renaming a file onto a device would replace the device
    if(fs::exists(target, error) && !fs::is_regular_file(target, error))
      throw Output_error(name + " cannot be written: not a regular file");
    fs::path temporary = target;
    temporary.replace_filename("." + target.filename().string() + "." + process_id());
    m_interruption.add(temporary.string());
    m_files.push_back({place, target, temporary});
    errno = 0;
    if(!std::ofstream(temporary) || (fs::exists(target, error) && !std::ofstream(target, std::ios::app)))
      throw Output_error(name + " cannot be written" + reason());
  }

  // `write` is given a stream, unless the file was not announced: no name, not wanted. The file counts as written only
  // if all of it reached the disk.
  template <class Write>
  void write(const std::string& name, const Write& write)
  {
    for(const auto& file : m_files)
    {
      if(file.place != name)
        continue;
      if(name == "-")
      {
        m_standard_output.precision(17);
        write(m_standard_output);
        continue;
      }
      errno = 0;
      std::ofstream stream(file.temporary, std::ios::binary);
      stream.precision(17);
      write(stream);
      stream.close();
      if(!stream)
        throw Output_error(name + " cannot be written" + reason());
    }
  }

  void put_into_place()
  {
    if(use_standard_output())
      put_to_standard_output();
    m_interruption.ignore_from_now_on();
    for(const auto& file : m_files)
    {
      if(file.place == "-")
        continue;
      std::error_code error;
      if(std::filesystem::exists(file.target, error))
        std::filesystem::permissions(file.temporary, std::filesystem::status(file.target, error).permissions(), error);
      std::filesystem::rename(file.temporary, file.target, error);
      if(error)
        throw Output_error(file.place.string() + " cannot be written: " + error.message());
    }
    m_files.clear();
  }

  bool use_standard_output() const
  {
    return std::any_of(m_files.begin(), m_files.end(), [](const File& file) { return file.place == "-"; });
  }

private:
  void put_to_standard_output() const
  {
    set_binary(stdout);
    std::cout << m_standard_output.rdbuf() << std::flush;
    if(!std::cout)
      throw Output_error("standard output cannot be written");
  }

  struct File
  {
    std::filesystem::path place; // as it was named
    std::filesystem::path target;
    std::filesystem::path temporary;
  };

  // What a link points to is written, not the link; by the one name that a file has, however it is called.
  static std::filesystem::path target_of(const std::filesystem::path& place)
  {
    constexpr int most_links = 40;
    namespace fs = std::filesystem;
    std::error_code error;
    fs::path target = fs::absolute(place, error);
    for(int links = 0; links < most_links && fs::is_symlink(target, error); ++links)
      target = target.parent_path() / fs::read_symlink(target, error);
    const fs::path folder = fs::weakly_canonical(target.parent_path(), error);
    return (error ? target.parent_path() : folder) / target.filename();
  }

  static std::string reason() { return errno == 0 ? "" : ": " + std::generic_category().message(errno); }

  Interruption m_interruption;
  std::vector<File> m_files;
  std::stringstream m_standard_output; // kept until the end, as the files are
};

using Mesh_writer = void (*)(std::ostream&, const mesh_quality::Mesh&);

// How to write the format; throws if there is no such. With all digits where the format is
// text: reading the file gives the same coordinates.
inline Mesh_writer mesh_writer(const std::string& file_name, const std::string& format)
{
  using Mesh = mesh_quality::Mesh;
  if(format == "off")
    return [](std::ostream& out, const Mesh& mesh) {
      CGAL::IO::write_OFF(out, mesh, CGAL::parameters::stream_precision(17));
    };
  if(format == "obj")
    return [](std::ostream& out, const Mesh& mesh) {
      CGAL::IO::write_OBJ(out, mesh, CGAL::parameters::stream_precision(17));
    };
  if(format == "ply")
    return [](std::ostream& out, const Mesh& mesh) {
      CGAL::IO::set_binary_mode(out);
      CGAL::IO::write_PLY(out, mesh);
    };
  if(format == "stl")
    return [](std::ostream& out, const Mesh& mesh) {
      CGAL::IO::set_binary_mode(out);
      CGAL::IO::write_STL(out, mesh);
    };
  if(format == "ts")
    return [](std::ostream& out, const Mesh& mesh) {
      CGAL::IO::write_GOCAD(out, mesh, CGAL::parameters::stream_precision(17));
    };
  throw Output_error(file_name + " cannot be written: its ending is none of .off, .obj, .ply, .stl, .ts");
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OUTPUT_H
