/*!
 * \ingroup PkgMultisidedPatchesConcepts
 * \cgalConcept
 *
 * A surface over a `Polygonal_domain_2`, as far as meshing needs to know it: what `mesh_domain()`
 * and `tessellate()` ask of a patch. A class need not derive from anything to be a model.
 *
 * The const members may be called from several threads at once.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Multisided_patches::Concave_bezier_patch_3}
 * \cgalHasModels{CGAL::Multisided_patches::Generalized_bezier_patch_3}
 * \cgalHasModels{CGAL::Multisided_patches::S_patch_3}
 * \cgalHasModels{CGAL::Multisided_patches::Tensor_product_patch_3}
 * \cgalHasModels{CGAL::Multisided_patches::Bezier_triangle_3}
 * \cgalHasModelsEnd
 */
class MultisidedPatch_3 {
public:
  //! a CGAL kernel with exact predicates
  using Geom_traits = unspecified_type;
  using Point_2 = Geom_traits::Point_2;
  using Point_3 = Geom_traits::Point_3;
  using Vector_3 = Geom_traits::Vector_3;

  const Polygonal_domain_2<Geom_traits>& domain() const;

  /*!
   * the point of the surface at `uv` (model units).
   *
   * `location` says where `uv` lies in the domain. If it is on the boundary, the point must depend
   * on nothing but `location`, because `uv` is rounded. Patches that share a boundary curve must
   * agree on its points, bit for bit, if they are to be meshed alike: at parameter s of the one,
   * and at s, or 1 - s, of the other, where 1 - s is exact.
   */
  Point_3 point(const Point_2& uv, const Polygonal_domain_2<Geom_traits>::Location& location) const;

  /*!
   * the same point, and the unit normal there, or the zero vector where there is none; the normal
   * points to the side from which the boundary runs counterclockwise.
   */
  std::pair<Point_3, Vector_3>
  point_and_normal(const Point_2& uv,
                   const Polygonal_domain_2<Geom_traits>::Location& location) const;

  /*!
   * writes what `point_and_normal()` gives for many points to `out`, in order, and returns one past
   * the last element written. Optional: it need not be there, but may be faster.
   *
   * \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the result must not depend on it
   * \tparam PointRange, LocationRange random access ranges of the same size
   */
  template <typename ConcurrencyTag, typename PointRange, typename LocationRange,
            typename OutputIterator>
  OutputIterator points_and_normals(const PointRange& points, const LocationRange& locations,
                                    OutputIterator out) const;
};
