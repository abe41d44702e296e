// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CURVE_PHASE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CURVE_PHASE_H

#include <CGAL/Geodesic_remeshing/internal/Level_curves.h>
#include <CGAL/Geodesic_remeshing/internal/Sample_set.h>
#include <CGAL/Geodesic_remeshing/internal/Sampled_path.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Where on the path of a curve the first of its samples goes (paper, section 6): so that each is opposite the middle of
// an edge of the curve before.
class Curve_phase
{
public:
  Curve_phase(const Sampled_path& path, const Sample_set& samples, double edge_length, std::size_t samples_of_a_block,
              const Concurrency concurrency)
    : m_path(path), m_samples(samples), m_edge_length(edge_length), m_samples_of_a_block(samples_of_a_block),
      m_concurrency(concurrency)
  {}

  // The phase in [0, 1) that agrees best with the curve before: each of its samples near this curve votes for the
  // middle of a step being opposite to it. The votes are directions, and their sum is the answer.
  double operator()(const Level_curve& curve, int n) const
  {
    const double step = m_path.length() / n;
    const auto votes_of = [&](const std::size_t begin, const std::size_t end) {
      Votes votes;
      for(std::size_t i = begin; i < end; ++i)
        collect_votes(curve, static_cast<double>(i) * step, step, votes);
      return votes;
    };
    const auto sum = [](const Votes& a, const Votes& b) { return Votes{a.x + b.x, a.y + b.y}; };
    const Votes votes = parallel_reduce(m_concurrency, n, Votes(), votes_of, sum, m_samples_of_a_block);
    if(votes.x * votes.x + votes.y * votes.y < 1e-12)
      return 0.;
    const double vote = std::atan2(votes.y, votes.x) / (2. * CGAL_PI) + .5;
    return vote - std::floor(vote);
  }

private:
  struct Votes
  {
    double x = 0., y = 0.;
  };

  // Of the samples near the point of the curve at `s`
  void collect_votes(const Level_curve& curve, double s, double step, Votes& votes) const
  {
    const std::vector<double>& lengths = m_path.lengths();
    const std::size_t j = (std::min)(std::size_t(std::upper_bound(lengths.begin(), lengths.end(), s) - lengths.begin()),
                                     lengths.size() - 1);
    const double l = lengths[j] - lengths[j - 1];
    if(!(l > 0.))
      return;
    const Vector tangent =
        (m_path.point(j).point - m_path.point(j - 1).point) / l; // a unit vector, but for the density
    const Point here = m_path.point(j - 1).point + (s - lengths[j - 1]) * tangent;
    const double density = .5 * (m_path.point(j - 1).density + m_path.point(j).density);
    const auto vote = [&](const Sample& other, const Point& q) {
      if(!is_before(other, curve))
        return;
      const double offset = density * density * ((q - here) * tangent);
      if(std::abs(offset) > .75 * step)
        return; // another step's business
      // on the square |x| + |y| = 1 in place of the circle: as good a direction, and no sine
      const double turn = offset / step - std::floor(offset / step); // in [0, 1)
      votes.x += turn < .5 ? 1. - 4. * turn : 4. * turn - 3.;
      votes.y += turn < .25 ? 4. * turn : (turn < .75 ? 2. - 4. * turn : 4. * turn - 4.);
    };
    m_samples.for_each_near(here, 1. / density, 1.3 * m_edge_length / density, vote);
  }

  bool is_before(const Sample& sample, const Level_curve& curve) const
  {
    return sample.region == curve.region ? sample.level == curve.level - 1 : curve.level == 1;
  }

  const Sampled_path& m_path;
  const Sample_set& m_samples;
  const double m_edge_length;
  const std::size_t m_samples_of_a_block;
  const Concurrency m_concurrency;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CURVE_PHASE_H
