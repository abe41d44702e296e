// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_BATCH_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_BATCH_H

#include "../command_line/system.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

extern char** environ;

// A folder of models, remeshed one by one with geodesic_remesh. Each model is a process of its own: one that fails or
// runs out of memory takes no other with it. A result appears as a whole or not at all, so that what there is of a run
// that was broken off is done.
namespace batch {

namespace fs = std::filesystem;

struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

enum class Outcome { done, failed, interrupted };

inline volatile std::sig_atomic_t interrupted = 0;

// Ctrl-C reaches the running processes as well, which end without a trace; no more are started then.
inline void stop_at_interrupt()
{
  for(const int signal : {SIGINT, SIGTERM})
    std::signal(signal, [](int) { interrupted = 1; });
}

class Batch
{
public:
  // PROGRAM INPUT_FOLDER OUTPUT_FOLDER OPTION...
  Batch(int argc, const char* const* argv)
  {
    if(argc < 4)
      throw Usage_error(std::string("usage: ") + fs::path(argv[0]).filename().string() +
                        " INPUT_FOLDER OUTPUT_FOLDER OPTIONS OF geodesic_remesh, as --vertices 5000");
    m_input = argv[1];
    m_output = argv[2];
    m_options.assign(argv + 3, argv + argc);
    // as many processes as processors are enough
    if(std::none_of(m_options.begin(), m_options.end(),
                    [](const std::string& option) { return option.rfind("--threads", 0) == 0; }))
      m_options.insert(m_options.end(), {"--threads", "1"});
    const fs::path beside = fs::path(argv[0]).parent_path() / "geodesic_remesh";
    m_program = fs::exists(beside) ? beside.string() : "geodesic_remesh"; // else the one in the path
    if(!fs::is_directory(m_input))
      throw Usage_error(m_input.string() + " is no folder");
    fs::create_directories(m_output);
    if(fs::equivalent(m_input, m_output))
      throw Usage_error("the results need a folder of their own");
    find_models();
  }

  // The models that have no result newer than they are, the largest first: the last ones to be remeshed, which some
  // processors wait for, are small ones then.
  const std::vector<fs::path>& models() const { return m_models; }
  std::size_t number_of_models_done_before() const { return m_done_before; }

  // Blocks until the model is remeshed. What geodesic_remesh says about a failure is in OUTPUT_FOLDER/NAME.log.
  Outcome remesh(const fs::path& model) const
  {
    const fs::path result = result_of(model), log = beside(result, ".log");
    std::vector<std::string> words = {m_program, model.string(), result.string(),
                                      "--quiet", "--report",     beside(result, ".json").string()};
    words.insert(words.end(), m_options.begin(), m_options.end());
    const int status = run(words, log);
    const Outcome outcome = status == 0 ? Outcome::done : interrupted != 0 ? Outcome::interrupted : Outcome::failed;
    if(outcome == Outcome::failed && status == not_valid)
      std::ofstream(log) << "the check found a fault\n";
    std::error_code ignored;
    if(outcome != Outcome::failed)
      fs::remove(log, ignored);
    return outcome;
  }

  std::string reason_of_failure(const fs::path& model) const
  {
    std::ifstream log(beside(result_of(model), ".log"));
    std::string line;
    std::getline(log, line);
    return line;
  }

private:
  static constexpr int not_valid = 4; // the exit status with --check

  // The result has the whole name of the model, so that a.off and a.obj do not write the same file.
  fs::path result_of(const fs::path& model) const
  {
    const std::string option = "--output-format";
    std::string format = "off";
    for(auto word = m_options.begin(); word != m_options.end(); ++word)
      if(word->rfind(option + "=", 0) == 0)
        format = word->substr(option.size() + 1);
      else if(*word == option && word + 1 != m_options.end())
        format = word[1];
    return m_output / (model.filename().string() + "." + format);
  }

  static fs::path beside(const fs::path& result, const std::string& ending)
  {
    return fs::path(result).replace_extension(ending);
  }

  static bool is_mesh(const fs::path& file)
  {
    static const std::set<std::string> endings = {".off", ".obj", ".ply", ".stl", ".ts"};
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return endings.count(ending) == 1;
  }

  void find_models()
  {
    for(const auto& entry : fs::directory_iterator(m_input))
    {
      if(!entry.is_regular_file() || !is_mesh(entry.path()))
        continue;
      const fs::path result = result_of(entry.path());
      if(fs::exists(result) && fs::last_write_time(result) >= entry.last_write_time() &&
         !fs::exists(beside(result, ".log"))) // what has one is there, but not valid
        ++m_done_before;
      else
        m_models.push_back(entry.path());
    }
    std::sort(m_models.begin(), m_models.end()); // the same order everywhere
    std::stable_sort(m_models.begin(), m_models.end(),
                     [](const fs::path& a, const fs::path& b) { return fs::file_size(a) > fs::file_size(b); });
  }

  // A process with these words as its arguments; returns its exit status, -1 if it has none.
  static int run(const std::vector<std::string>& words, const fs::path& log)
  {
    std::vector<char*> arguments;
    for(const std::string& word : words)
      arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t streams;
    posix_spawn_file_actions_init(&streams);
    posix_spawn_file_actions_addopen(&streams, 2, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    pid_t process = 0;
    const int error = posix_spawnp(&process, arguments[0], &streams, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&streams);
    if(error != 0)
    {
      std::ofstream(log) << words[0] << " cannot be run\n";
      return -1;
    }
    int status = 0;
    while(waitpid(process, &status, 0) == -1 && errno == EINTR)
      ; // a signal came in between
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  fs::path m_input;
  fs::path m_output;
  std::string m_program;
  std::vector<std::string> m_options;
  std::vector<fs::path> m_models;
  std::size_t m_done_before = 0;
};

// Tells how far it is: one line that changes on a terminal, otherwise a line for each model
class Batch_progress
{
public:
  explicit Batch_progress(const Batch& batch)
    : m_batch(batch), m_on_terminal(command_line::standard_error_is_a_terminal())
  {
    if(batch.number_of_models_done_before() > 0)
      std::cerr << batch.number_of_models_done_before() << " models are done already\n";
  }

  void show(const fs::path& model, Outcome outcome)
  {
    if(outcome == Outcome::interrupted)
      return;
    ++m_count;
    const std::string text = "[" + std::to_string(m_count) + "/" + std::to_string(m_batch.models().size()) + "] " +
                             model.filename().string();
    std::cerr << (m_on_terminal ? "\r\033[K" : "") << text;
    if(outcome == Outcome::failed)
    {
      ++m_failures;
      std::cerr << ": " << m_batch.reason_of_failure(model) << "\n";
    }
    else if(!m_on_terminal)
      std::cerr << "\n";
    std::cerr << std::flush;
  }

  // The exit status: whether all models are done
  int end() const
  {
    std::cerr << (m_on_terminal ? "\r\033[K" : "") << m_count - m_failures << " models remeshed, " << m_failures
              << " failed";
    std::cerr << (interrupted != 0 ? "; interrupted: the same command goes on from here\n" : "\n");
    return m_failures == 0 && interrupted == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }

private:
  const Batch& m_batch;
  bool m_on_terminal;
  std::size_t m_count = 0;
  std::size_t m_failures = 0;
};

} // namespace batch

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_BATCH_H
