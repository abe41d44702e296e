// Remeshes all models of a folder over all processors of this machine:
//
//   geodesic_remesh_folder models remeshed --vertices 5000
//
// The same command again goes on where it was broken off.

#include "Batch.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

namespace {

int run(const batch::Batch& models)
{
  batch::Batch_progress progress(models);
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  const auto work = [&] {
    for(std::size_t i = 0; batch::interrupted == 0 && (i = next++) < models.models().size();)
    {
      const auto& model = models.models()[i];
      const batch::Outcome outcome = models.remesh(model);
      const std::lock_guard<std::mutex> lock(mutex);
      progress.show(model, outcome);
    }
  };
  std::vector<std::thread> threads;
  for(unsigned int i = 1; i < (std::max)(1u, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back(work);
  work();
  for(std::thread& thread : threads)
    thread.join();
  return progress.end();
}

} // namespace

int main(int argc, char* argv[])
{
  batch::stop_at_interrupt();
  try
  {
    return run(batch::Batch(argc, argv));
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
