// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef GEODESIC_REMESHING_COMMAND_LINE_SUPPORT_H
#define GEODESIC_REMESHING_COMMAND_LINE_SUPPORT_H

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

// Tests that run geodesic_remesh from outside: a folder for each test, and what the program wrote.
namespace command_line_support {

namespace fs = std::filesystem;

inline std::string contents(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

struct Outcome
{
  int status;
  std::string out;
  std::string err;
};

// Each test has an empty folder for its files and another one for what the program writes.
class Command_line : public ::testing::Test
{
protected:
  void SetUp() override
  {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::temp_directory_path() / ("geodesic_remesh." + std::to_string(getpid()) + "." + test->name());
    fs::create_directories(folder / "written");
  }

  void TearDown() override { fs::remove_all(folder); }

  Outcome run(const std::string& arguments) const
  {
    const std::string command = std::string("'") + GEODESIC_REMESH_PROGRAM + "' " + arguments + " >'" +
                                (folder / "stdout").string() + "' 2>'" + (folder / "stderr").string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(folder / "stdout"), contents(folder / "stderr")};
  }

  std::string file(const std::string& name, const std::string& text) const
  {
    std::ofstream(folder / name, std::ios::binary) << text;
    return (folder / name).string();
  }

  std::string output(const std::string& name = "out.off") const { return (folder / "written" / name).string(); }

  // the error is one line, nothing is on standard output, and no file has appeared
  void expect_failure(const std::string& arguments, int status, const std::string& words) const
  {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(fs::is_empty(folder / "written"));
  }

  void expect_bad_input(const std::string& input, const std::string& words) const
  {
    expect_failure("'" + input + "' '" + output() + "' --vertices 100", 2, words);
  }

  fs::path folder;
};

inline std::string mesh(const std::string& name)
{
  return std::string(MESHES_FOLDER "/") + name + ".off";
}

inline std::array<std::size_t, 2> vertices_and_faces_of_off(const std::string& name)
{
  std::ifstream in(name);
  std::string word;
  std::array<std::size_t, 2> counts{};
  in >> word >> counts[0] >> counts[1];
  EXPECT_EQ(word, "OFF");
  return counts;
}

} // namespace command_line_support

#endif // GEODESIC_REMESHING_COMMAND_LINE_SUPPORT_H
