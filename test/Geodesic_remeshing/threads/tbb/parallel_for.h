// What the package uses of TBB, made of standard threads: ThreadSanitizer knows what these wait for, but not what TBB
// does inside its library, and would report every hand-over of data to a task.

#ifndef GEODESIC_REMESHING_TEST_THREADS_TBB_PARALLEL_FOR_H
#define GEODESIC_REMESHING_TEST_THREADS_TBB_PARALLEL_FOR_H

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body)
{
  std::atomic<Index> next{first};
  std::exception_ptr error;
  std::mutex mutex;
  const auto work = [&] {
    try
    {
      for(Index i = next++; i < last; i = next++)
        body(i);
    }
    catch(...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      error = std::current_exception();
      next = last;
    }
  };
  std::vector<std::thread> threads;
  for(int i = 0; i < 3; ++i)
    threads.emplace_back(work);
  work();
  for(std::thread& thread : threads)
    thread.join();
  if(error)
    std::rethrow_exception(error);
}

template <class Range, class Body>
void parallel_for(const Range& range, const Body& body)
{
  parallel_for(range.begin(), range.end(), [&](const auto i) { body(Range(i, i + 1)); });
}

template <class First, class Second>
void parallel_invoke(const First& first, const Second& second)
{
  parallel_for(0, 2, [&](const int i) { i == 0 ? first() : second(); });
}

template <class Iterator, class Less>
void parallel_sort(Iterator begin, Iterator end, const Less& less)
{
  std::sort(begin, end, less);
}

} // namespace tbb

#endif // GEODESIC_REMESHING_TEST_THREADS_TBB_PARALLEL_FOR_H
