/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The computation between a surface and its segments: a value with constants as members and two
functions. `CGAL::Region_segmentation::segment()` and `CGAL::Region_segmentation::Segmenter` store a
copy. Every run is `const`, so a method can be used again, also from several threads; values that
copies share are held by pointers.

What a method reads and returns:

| call | gives |
|---|---|
| `surface.number_of_faces()`, `surface.normal(f)` | the unit normal of a face, 0 of a degenerate
one | | `surface.area(f)`, `surface.weight(f)` | its area; the same, but 0 in a crumb: for sums over
the surface | | `surface.centroid(f)`, `surface.length_unit()` | its centroid, a `Double_3` with the
members `x`, `y`, `z`, as all points and vectors of a `Surface`; the unit of lengths | |
`surface.number_of_adjacencies()`, `lower_face(a)`, `higher_face(a)` | pairs of faces | |
`surface.length(a)`, `deviation(a)`, `has_flag(a, Surface::CONCAVE)` | of an adjacency; the length
of a link is that of the contact, 0 between components that are apart | | `surface.has_flag(a,
Surface::SEAM \| Surface::LINK)` | whether it is a seam or a link; `deviation(a)` is 0 at a link and
at a degenerate face | | `surface.has_flag(a, Surface::CONSTRAINED)` | whether it is constrained:
first regions do not cross it | | `grow_regions(surface, detect_feature_edges(surface, 30))`,
`Superfacets()(surface, patches)` | first regions, which no link joins | | `requested_regions()`,
`merge_requested_regions()` | in the headers of these names; merged down to 1 there is a tree for
all numbers | | `Number_below_cost()(tree, surface)` and the like | a number where none is requested
| | `Partition::from_labels(labels)` | a partition of the faces by any labels, numbered by first
faces | | `request.number_of_segments`, `seeds` | the request | | `Segmentation(segments,
Merge_tree(k), k)` | `segments`: a partition of the faces into k; no merges | |
`execution.stage("merging")`, `report(x)` | the stage that a visitor sees, of any name; its progress
|

Regions need not be connected. A method that cannot meet constraints or seeds throws
`Invalid_input`.

A method for parts may have a member `static constexpr bool fills_voids = true`: then it is given
surfaces without the faces of voids (\ref RegionSegmentationVoids), whose numbers of faces are not
those of the mesh. With `static constexpr bool smooths_noise = true` it is given surfaces without
noise (\ref RegionSegmentationNoise); a `Segmenter` keeps these alone.

These two functions and the type `Prepared` are all that a method needs. The type that `merge()`
returns tells whether the order of merges depends on the number of segments. A method of a user's
own is shown in \ref RegionSegmentationOwnMethod.

\cgalHasModel `CGAL::Region_segmentation::Learned_merging`
\cgalHasModel `CGAL::Region_segmentation::Visibility_merging`
\cgalHasModel `CGAL::Region_segmentation::Smooth_faces`
\cgalHasModel `CGAL::Region_segmentation::Two_step`
\cgalHasModel `CGAL::Region_segmentation::Superfacet_merging`
*/
class SegmentationMethod
{
public:
  /// what `prepare()` returns: any type that can be moved.
  struct Prepared;

  /// computes what does not depend on seeds, such as first regions. These do not cross adjacencies
  /// that are `Surface::CONSTRAINED`. A `Segmenter` calls it once, and again for more constraints.
  /// It begins by checking the constants, those of the parts of the package by their
  /// `check_constants()`.
  /// \param surface the surface to be segmented
  /// \param number_of_segments the number that was given to `segment()` or to the constructor of
  ///        the `Segmenter`, for which there should be enough first regions; 0 if none was given. A
  ///        method may ignore it
  /// \param execution as below
  /// \throws CGAL::Region_segmentation::Invalid_method if a constant is not in its range
  Prepared prepare(const Surface& surface, std::size_t number_of_segments,
                   const Execution& execution) const;

  /*!
  segments the surface as the request says: with its number, or one of its own choice if that is 0,
  and its seeds, which `CGAL::Region_segmentation::requested_regions()` applies to first regions.

  The result depends on the arguments alone, not on earlier calls.

  \returns `Hierarchy`, or a type derived from it, if the order of merges does not depend on the
  number of segments: a `Segmenter` calls it once for each change of constraints or seeds. Otherwise
  `Segmentation`, a hierarchy for one number: it is called for each number, which must be given
  \throws Invalid_input if the request cannot be met
  */
  Hierarchy merge(const Surface& surface, const Prepared& prepared, const Request& request,
                  const Execution& execution) const;
};
