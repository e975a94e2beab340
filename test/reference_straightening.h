// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_REFERENCE_STRAIGHTENING_H
#define CGAL_REGION_SEGMENTATION_TEST_REFERENCE_STRAIGHTENING_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <utility>
#include <vector>

// The slow, obvious implementation of `Border_straightening`, written from its documentation:
// everything is computed anew for each merge, and flows are found by augmenting along shortest
// paths.

namespace reference {

/// Elements with borders between them, which regions and their merges are made of.
struct Straightening_input
{
  std::vector<double> areas; // of the elements, relative to the surface
  std::vector<std::map<std::size_t, double>> costs,
    lengths; // by element and adjacent element: of border and step
  std::vector<std::size_t> region_of;
  std::vector<std::pair<std::size_t, std::size_t>> merges; // kept, removed
  std::size_t number_of_cuts = 63;
  double width = 0.03, width_of_segment = 0.2;
};

class Straightening
{
public:
  explicit Straightening(Straightening_input input)
    : m_in(std::move(input))
    , m_is_own(m_in.areas.size(), true)
    , m_label(labels_after(m_in.merges.size()))
  {
    for (std::size_t i = m_in.merges.size(); i-- > 0;)
      undo(i);
  }

  /// The region of each element.
  const std::vector<std::size_t>& labels() const { return m_label; }

private:
  using Elements = std::vector<std::size_t>;
  static constexpr std::size_t none = std::size_t(-1);

  /// Of the elements, by their former regions.
  std::vector<std::size_t> labels_after(std::size_t number_of_merges) const
  {
    std::map<std::size_t, std::size_t> segment_of; // from the last merge on, so that what is kept
                                                   // has its segment
    for (std::size_t i = number_of_merges; i-- > 0;) {
      const auto [kept, removed] = m_in.merges[i];
      segment_of[removed] = segment_of.emplace(kept, kept).first->second;
    }
    std::vector<std::size_t> labels = m_in.region_of;
    for (std::size_t& label : labels)
      label = segment_of.emplace(label, label).first->second;
    return labels;
  }

  void undo(std::size_t i)
  {
    const auto [a, b] = m_in.merges[i];
    const std::vector<std::size_t> by_region = labels_after(i);
    Elements segment;
    for (std::size_t e = 0; e < m_label.size(); ++e)
      if (m_label[e] == a)
        segment.push_back(e);
    for (std::size_t e : segment)
      m_label[e] = m_is_own[e] ? by_region[e] : none;
    for (std::size_t part : {a, b})
      keep_largest_component(segment, part);
    join(segment, a, b);
    if (m_in.merges.size() - i <= m_in.number_of_cuts)
      cut(segment, a, b);
  }

  std::set<std::size_t> component(std::size_t first) const
  {
    std::set<std::size_t> result{first};
    Elements front{first};
    while (!front.empty()) {
      const std::size_t e = front.back();
      front.pop_back();
      for (const auto& step : m_in.costs[e])
        if (m_label[step.first] == m_label[first] && result.insert(step.first).second)
          front.push_back(step.first);
    }
    return result;
  }

  void keep_largest_component(const Elements& segment, std::size_t part)
  {
    std::set<std::size_t> largest;
    double largest_area = -1;
    for (std::size_t e : segment)
      if (m_label[e] == part && largest.count(e) == 0) {
        const std::set<std::size_t> next = component(e);
        double area = 0;
        for (std::size_t f : next)
          area += m_in.areas[f];
        if (area > largest_area) {
          largest = next;
          largest_area = area;
        }
      }
    for (std::size_t e : segment)
      if (m_label[e] == part && largest.count(e) == 0) {
        m_label[e] = none;
        m_is_own[e] = false;
      }
  }

  void join(const Elements& segment, std::size_t a, std::size_t b)
  {
    for (bool has_joined = true; has_joined;) {
      std::map<std::size_t, std::size_t> joined;
      for (std::size_t e : segment)
        if (m_label[e] == none) {
          std::map<std::size_t, double> cost;
          for (const auto& [f, c] : m_in.costs[e])
            cost[m_label[f]] += c;
          if (cost.count(a) + cost.count(b) > 0)
            joined[e] = cost.count(b) == 0 || (cost.count(a) > 0 && cost[a] >= cost[b]) ? a : b;
        }
      for (const auto& [e, part] : joined)
        m_label[e] = part;
      has_joined = !joined.empty();
    }
    for (std::size_t e : segment) // of parts without elements of their own
      if (m_label[e] == none)
        m_label[e] = a;
  }

  void cut(const Elements& segment, std::size_t a, std::size_t b)
  {
    const std::vector<std::size_t> before = m_label;
    double area_of_a = 0, area_of_b = 0;
    for (std::size_t e : segment)
      (m_label[e] == a ? area_of_a : area_of_b) += m_in.areas[e];
    const double width = std::min(m_in.width, m_in.width_of_segment *
                                                std::sqrt(std::min(area_of_a, area_of_b)));
    if (width < 1e-6)
      return;
    const std::set<std::size_t> band = band_of(segment, a, b, width);
    std::map<std::size_t, std::size_t> node_of;
    std::size_t nodes = 2, stays_in_a = 0, stays_in_b = 0;
    for (std::size_t e : band) {
      bool stays = false;
      for (const auto& step : m_in.costs[e])
        stays |= m_label[step.first] == m_label[e] && band.count(step.first) == 0;
      node_of[e] = !stays ? nodes++ : m_label[e] == a ? source : sink;
      (m_label[e] == a ? stays_in_a : stays_in_b) += stays;
    }
    if (stays_in_a == 0 || stays_in_b == 0)
      return;
    Network network(nodes);
    for (std::size_t e : band) {
      if (node_of[e] > sink)
        network.add(node_of[e], m_label[e] == a ? source : sink, 1); // moving costs something
      for (const auto& [f, c] : m_in.costs[e]) {
        const std::int64_t capacity = std::max<std::int64_t>(1, std::llround(std::ldexp(c, 38))) *
                                      std::int64_t(nodes);
        if (band.count(f) > 0 && e < f)
          network.add(node_of[e], node_of[f], capacity);
        else if (band.count(f) == 0 && (m_label[f] == a || m_label[f] == b))
          network.add(node_of[e], m_label[f] == a ? source : sink, capacity);
      }
    }
    const std::vector<bool> is_in_a = network.source_side();
    for (std::size_t e : band)
      m_label[e] = is_in_a[node_of[e]] ? a : b;
    for (std::size_t part : {a, b}) {
      const auto first = std::find(m_label.begin(), m_label.end(), part);
      if (component(std::size_t(first - m_label.begin())).size() !=
          std::size_t(std::count(m_label.begin(), m_label.end(), part))) {
        m_label = before;
        return;
      }
    }
    for (std::size_t e : band)
      if (m_label[e] != before[e])
        m_is_own[e] = false;
  }

  std::set<std::size_t> band_of(const Elements& segment, std::size_t a, std::size_t b,
                                double width) const
  {
    std::map<std::size_t, double> distance;
    for (std::size_t e : segment)
      for (const auto& step : m_in.costs[e])
        if (m_label[step.first] == (m_label[e] == a ? b : a))
          distance[e] = 0;
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (std::size_t e : segment)
        if (distance.count(e) > 0)
          for (const auto& [f, length] : m_in.lengths[e]) {
            const double d = distance[e] + length;
            if (m_label[f] == m_label[e] && d <= width &&
                (distance.count(f) == 0 || d < distance[f])) {
              distance[f] = d;
              has_changed = true;
            }
          }
    }
    std::set<std::size_t> band;
    for (const auto& entry : distance)
      band.insert(entry.first);
    return band;
  }

  static constexpr std::size_t source = 0, sink = 1;

  struct Network
  {
    std::vector<std::map<std::size_t, std::int64_t>> residual;

    explicit Network(std::size_t nodes)
      : residual(nodes)
    {}

    void add(std::size_t a, std::size_t b, std::int64_t capacity)
    {
      if (a == b)
        return;
      residual[a][b] += capacity;
      residual[b][a] += capacity;
    }

    /// The nodes that the source reaches when the flow is maximal.
    std::vector<bool> source_side()
    {
      while (true) {
        std::vector<std::size_t> predecessor(residual.size(), none);
        std::queue<std::size_t> front;
        front.push(source);
        predecessor[source] = source;
        while (!front.empty() && predecessor[sink] == none) {
          const std::size_t n = front.front();
          front.pop();
          for (const auto& [m, capacity] : residual[n])
            if (capacity > 0 && predecessor[m] == none) {
              predecessor[m] = n;
              front.push(m);
            }
        }
        if (predecessor[sink] == none) {
          std::vector<bool> is_reached;
          for (std::size_t p : predecessor)
            is_reached.push_back(p != none);
          return is_reached;
        }
        std::int64_t flow = (std::numeric_limits<std::int64_t>::max)();
        for (std::size_t n = sink; n != source; n = predecessor[n])
          flow = std::min(flow, residual[predecessor[n]][n]);
        for (std::size_t n = sink; n != source; n = predecessor[n]) {
          residual[predecessor[n]][n] -= flow;
          residual[n][predecessor[n]] += flow;
        }
      }
    }
  };

  Straightening_input m_in;
  std::vector<bool> m_is_own;
  std::vector<std::size_t> m_label;
};

} // namespace reference

#endif // CGAL_REGION_SEGMENTATION_TEST_REFERENCE_STRAIGHTENING_H
