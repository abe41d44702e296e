// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_PARALLEL_FOR_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_PARALLEL_FOR_H

#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The only header that knows of TBB. What is here gives the same bytes with one thread and with many: an index writes
// only what is its own, blocks are as large whatever the number of threads, and what they return is put together in
// their order.

// Whether a stage may use several threads: what the user's `concurrency_tag` says. A value, not a type, so that the
// stages need not be compiled twice.
class Concurrency
{
public:
  Concurrency() = default; // one thread

  template <class Tag>
  explicit Concurrency(const Tag&) : m_is_parallel(std::is_convertible<Tag, Parallel_tag>::value)
  {
#ifndef CGAL_LINKED_WITH_TBB
    static_assert(!std::is_convertible<Tag, Parallel_tag>::value, "Parallel_tag is enabled but TBB is unavailable.");
#endif
  }

  bool is_parallel() const
  {
    return m_is_parallel;
  }

private:
  bool m_is_parallel = false;
};

template <class NamedParameters>
using Concurrency_tag_of = typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::concurrency_tag_t,
                                                                              NamedParameters, Sequential_tag>::type;

template <class NamedParameters>
Concurrency concurrency_of(const NamedParameters&)
{
  return Concurrency(Concurrency_tag_of<NamedParameters>());
}

// A task of fewer indices than this is not worth its start where an index costs some ten nanoseconds.
constexpr std::size_t usual_block = 4096;

// Calls `body(begin, end)` for the blocks [0, block), [block, 2 block) ... of [0, n).
template <class Body>
void for_each_block(const Concurrency concurrency, const std::size_t n, const std::size_t block, const Body& body)
{
  const auto run = [&](const std::size_t i) { body(i * block, (std::min)(n, (i + 1) * block)); };
  const std::size_t number = n / block + (n % block != 0);
#ifdef CGAL_LINKED_WITH_TBB
  if(concurrency.is_parallel() && number > 1)
  {
    tbb::parallel_for(std::size_t(0), number, run);
    return;
  }
#else
  (void)concurrency;
#endif
  for(std::size_t i = 0; i < number; ++i)
    run(i);
}

// Calls `body(i)` for each i of [0, n).
template <class Body>
void parallel_for(const Concurrency concurrency, const std::size_t n, const Body& body,
                  const std::size_t block = usual_block)
{
  for_each_block(concurrency, n, block, [&](const std::size_t begin, const std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      body(i);
  });
}

// `combine(... combine(combine(first, x_0), x_1) ..., x_k)` for the values x_i = `body(begin, end)` of the blocks. Sums
// of floating-point numbers are those of one thread, since also that adds up by blocks.
template <class Value, class Body, class Combine>
Value parallel_reduce(const Concurrency concurrency, const std::size_t n, Value first, const Body& body,
                      const Combine& combine, const std::size_t block = usual_block)
{
  std::vector<Value> values(n / block + (n % block != 0), first);
  for_each_block(concurrency, n, block,
                 [&](const std::size_t begin, const std::size_t end) { values[begin / block] = body(begin, end); });
  for(const Value& value : values)
    first = combine(std::move(first), value);
  return first;
}

// The i of [0, n) that are `wanted(i)`, in their order
template <class Wanted>
std::vector<std::uint32_t> parallel_list(const Concurrency concurrency, const std::size_t n, const Wanted& wanted)
{
  using List = std::vector<std::uint32_t>;
  const auto list = [&](const std::size_t begin, const std::size_t end) {
    List result;
    for(std::size_t i = begin; i < end; ++i)
      if(wanted(static_cast<std::uint32_t>(i)))
        result.push_back(static_cast<std::uint32_t>(i));
    return result;
  };
  const auto append = [](List all, const List& some) {
    all.insert(all.end(), some.begin(), some.end());
    return all;
  };
  return parallel_reduce(concurrency, n, List(), list, append);
}

// Calls both, which must not touch what the other writes.
template <class First, class Second>
void parallel_invoke(const Concurrency concurrency, const First& first, const Second& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(concurrency.is_parallel())
  {
    tbb::parallel_invoke(first, second);
    return;
  }
#else
  (void)concurrency;
#endif
  first();
  second();
}

// An object for each thread that asks for one: memory that steps use again, without a trace of those before in what
// they do.
template <class T>
class Per_thread
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  template <class Make>
  explicit Per_thread(const Make& make) : m_objects(make)
  {}

  T& local()
  {
    return m_objects.local();
  }

private:
  tbb::enumerable_thread_specific<T> m_objects;
#else
  template <class Make>
  explicit Per_thread(const Make& make) : m_object(make())
  {}

  T& local()
  {
    return m_object;
  }

private:
  T m_object;
#endif
};

// Sorts by a total order: with one in which different elements are equivalent the result would be any.
template <class Iterator, class Less>
void parallel_sort(const Concurrency concurrency, const Iterator begin, const Iterator end, const Less& less)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(concurrency.is_parallel())
  {
    tbb::parallel_sort(begin, end, less);
    return;
  }
#else
  (void)concurrency;
#endif
  std::sort(begin, end, less);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_PARALLEL_FOR_H
