// SPDX-License-Identifier: GPL-3.0-or-later

#include "Measurement.h"

#include "allocated_bytes.h"

#include <algorithm>

namespace speed_benchmark {

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

namespace {

struct Round
{
  double floor, slow_floor, reference;
  Stage_seconds subject;
};

template <typename Value>
double median_of(const std::vector<Round>& rounds, const Value& value)
{
  std::vector<double> values;
  for (const Round& r : rounds)
    values.push_back(value(r));
  return median(values);
}

Round run_round(const Contest& contest)
{
  Round round;
  round.floor = contest.floor();
  round.slow_floor = contest.slow_floor ? contest.slow_floor() : 0;
  round.subject = contest.subject();
  round.reference = contest.reference ? contest.reference() : 0;
  return round;
}

Measurement summarize(const std::vector<Round>& rounds, const Contest& contest)
{
  Measurement m;
  m.rounds = rounds.size();
  m.number_of_regions = rounds.front().subject.number_of_regions;
  for (std::size_t s = 0; s < number_of_stages; ++s)
    m.seconds_of_stage[s] = median_of(rounds,
                                      [&](const Round& r) { return r.subject.of_stage[s]; });
  m.seconds = median_of(rounds, [](const Round& r) { return r.subject.whole(); });
  m.floor_seconds = median_of(rounds, [](const Round& r) { return r.floor; });
  m.regions_by_floor = median_of(
    rounds, [](const Round& r) { return r.subject.until(Stage::GRAPH) / r.floor; });
  m.whole_by_floor = median_of(rounds, [](const Round& r) { return r.subject.whole() / r.floor; });
  if (contest.reference)
    m.by_reference = median_of(rounds, [&](const Round& r) {
      return r.subject.until(contest.compared_until) / r.reference;
    });
  if (contest.slow_floor)
    m.gain_of_floor = median_of(rounds, [](const Round& r) { return r.slow_floor / r.floor; });
  return m;
}

} // namespace

Measurement measure(const Contest& contest, double seconds_wanted)
{
  contest.floor();
  const std::size_t peak_bytes = peak_of_allocated_bytes([&] { contest.subject(); });
  std::vector<Round> rounds;
  const double start = seconds(Clock::WALL);
  do
    rounds.push_back(run_round(contest));
  while (rounds.size() < 3 || seconds(Clock::WALL) - start < seconds_wanted);
  Measurement m = summarize(rounds, contest);
  m.peak_bytes = peak_bytes;
  return m;
}

} // namespace speed_benchmark
