// The same over many machines, which share the folders:
//
//   mpirun geodesic_remesh_folder_mpi models remeshed --vertices 5000
//
// Process 0 hands out the models one by one and remeshes none; each of the others asks for the next as soon as it is
// free.

#include "Batch.h"

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/mpi/status.hpp>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace mpi = boost::mpi;

enum Tag { model_for_you, outcome_for_you };
const std::string no_more_models;

int hand_out(const mpi::communicator& world, const batch::Batch& models)
{
  batch::Batch_progress progress(models);
  std::vector<batch::fs::path> model_of(static_cast<std::size_t>(world.size()));
  std::size_t next = 0;
  int busy = 0;
  const auto send_next = [&](int worker) {
    const bool is_end = batch::interrupted != 0 || next == models.models().size();
    world.send(worker, model_for_you, is_end ? no_more_models : models.models()[next].string());
    if(is_end)
      return;
    model_of[static_cast<std::size_t>(worker)] = models.models()[next++];
    ++busy;
  };
  for(int worker = 1; worker < world.size(); ++worker)
    send_next(worker);
  while(busy > 0)
  {
    int outcome = 0;
    const mpi::status status = world.recv(mpi::any_source, outcome_for_you, outcome);
    --busy;
    progress.show(model_of[static_cast<std::size_t>(status.source())], static_cast<batch::Outcome>(outcome));
    send_next(status.source());
  }
  return progress.end();
}

int take(const mpi::communicator& world, const batch::Batch& models)
{
  std::string model;
  for(world.recv(0, model_for_you, model); model != no_more_models; world.recv(0, model_for_you, model))
    world.send(0, outcome_for_you, static_cast<int>(models.remesh(model)));
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char* argv[])
{
  const mpi::environment environment(argc, argv);
  const mpi::communicator world;
  if(world.size() < 2)
  {
    std::cerr << "needs two processes at least: mpirun -n 2 ...\n";
    return EXIT_FAILURE;
  }
  batch::stop_at_interrupt();
  try
  {
    const batch::Batch models(argc, argv);
    return world.rank() == 0 ? hand_out(world, models) : take(world, models);
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    mpi::environment::abort(EXIT_FAILURE); // the others would wait for this one
  }
}
