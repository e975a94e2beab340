/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The computation between a surface and its segments: a value with constants as members and two
functions. `CGAL::Region_segmentation::segment()` and `CGAL::Region_segmentation::Segmenter` store a
copy. Every run is `const`, so a method can be used again, also from several threads; values that
copies share are held by pointers.

Nothing else is looked for in a method. What it can do is said by the type that `merge()` returns. A
method of a user's own is shown in \ref RegionSegmentationOwnMethod.

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

  /// computes what depends on the surface alone, and on no request. First regions do not cross
  /// adjacencies that are `Surface::CONSTRAINED`. A `Segmenter` calls it once, and again for more
  /// constraints. It begins by checking the constants, those of the parts of the package by their
  /// `check_constants()`.
  /// \throws CGAL::Region_segmentation::Invalid_method if a constant is not in its range
  Prepared prepare(const Surface& surface, const Execution& execution) const;

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
