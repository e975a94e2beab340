// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_PUBLISHED_FIGURES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_PUBLISHED_FIGURES_H

#include <cstddef>

/// \file published_figures.h
/// What others have printed, all on the whole benchmark. Sources: Chen, Golovinskiy, Funkhouser
/// 2009 (all of the standard protocol but CEFM: Zhang 2015); Yang et al. 2014 ("the paper": its
/// protocol, tables and times).

namespace princeton_benchmark {

/// 1 - Rand index in the standard protocol.
struct Published_method
{
  const char* name;
  double mean;
  const char* seconds; ///< a model
  const char* number_of_segments;
};

constexpr Published_method published_methods[] = {
  {"People against each other", 0.103, "-", "-"},
  {"CEFM", 0.145, "< 15 per 10,000 triangles", "auto"},
  {"Randomized Cuts", 0.152, "83.8", "given"},
  {"Normalized Cuts", 0.172, "49.4", "given"},
  {"Shape Diameter", 0.175, "8.9", "auto"},
  {"Core Extraction", 0.210, "19.5", "auto"},
  {"Fitting Primitives", 0.210, "4.6", "given"},
  {"Random Walks", 0.214, "1.4", "given"},
  {"K-Means", 0.251, "2.5", "given"},
  {"A segment a face", 0.345, "-", "-"},
  {"One segment", 0.655, "-", "-"}};

/// 1 - Rand index in the paper's protocol.
struct Published_category
{
  const char* name;
  double randomized_cuts, random_walks, paper;
};

constexpr Published_category published_categories[] = {
  {"Human", .083, .279, .091},    {"Cup", .179, .316, .047},       {"Glasses", .053, .340, .058},
  {"Airplane", .115, .263, .064}, {"Ant", .014, .059, .021},       {"Chair", .147, .138, .051},
  {"Octopus", .064, .086, .024},  {"Table", .410, .103, .013},     {"Teddy", .030, .118, .028},
  {"Hand", .069, .194, .078},     {"Plier", .092, .214, .169},     {"Fish", .296, .383, .095},
  {"Bird", .074, .242, .088},     {"Armadillo", .066, .099, .090}, {"Bust", .136, .238, .158},
  {"Mech", .227, .147, .011},     {"Bearing", .026, .205, .004},   {"Vase", .081, .256, .063},
  {"FourLeg", .190, .275, .178}};

/// The means as they are printed, and as they follow from the printed rows, over the models and
/// over the categories: they differ.
constexpr Published_category published_means[] = {{"mean as printed", .125, .197, .069},
                                                  {"mean over models", .126, .207, .070},
                                                  {"mean over categories", .126, .208, .070}};

/// People in the paper's protocol: against the first person of the most common number of segments,
/// and against the nearest such person.
constexpr double published_people_first = .084, published_people_nearest = .064;

/// A row of the paper's table 2, on a Pentium of 2.9 GHz. Seconds.
struct Published_time
{
  const char* category;
  std::size_t triangles, segments;
  double features, growing, merging, total;
};

constexpr Published_time published_times[] = {
  {"Chair", 28744, 8, 0.30, 0.54, 3.52, 4.36},   {"Fish", 20368, 7, 0.16, 0.37, 12.3, 12.83},
  {"Bird", 10104, 5, 0.12, 0.19, 1.74, 2.05},    {"Hand", 17290, 7, 0.21, 0.33, 4.98, 5.52},
  {"Human", 30450, 15, 0.37, 0.62, 9.66, 10.65}, {"Table", 19600, 9, 0.21, 0.37, 5.73, 6.31},
  {"Vase", 28952, 6, 0.36, 0.55, 11.07, 11.98},  {"Octopus", 18244, 9, 0.22, 0.35, 3.03, 8.60}};

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_PUBLISHED_FIGURES_H
