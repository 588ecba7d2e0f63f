/*!
 * \ingroup PkgMultisidedPatchesConcepts
 * \cgalConcept
 *
 * Blending functions on the barycentric coordinates of a domain, one for each point of a control
 * net: what makes a net a surface. They depend on the structure of the net only, not on where its
 * points are, and sum to 1. A patch is such a basis, coordinates and control points; a new kind of
 * patch needs a new basis, and nothing else of its own.
 *
 * An object is immutable after construction, and all its members may be called from several threads
 * at once.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Multisided_patches::Concave_bezier_basis}
 * \cgalHasModels{CGAL::Multisided_patches::Generalized_bezier_basis}
 * \cgalHasModels{CGAL::Multisided_patches::S_patch_basis}
 * \cgalHasModelsEnd
 */
class ControlNetBasis {
public:
  //! the number n of sides, which is that of coordinates
  std::size_t number_of_sides() const;

  //! the number of weights, which is that of control points
  std::size_t size() const;

  /*!
   * memory that evaluation needs, default constructible. One object serves for one point after the
   * other, so that memory is allocated once, but not for several threads at a time.
   */
  template <typename T>
  using Workspace = unspecified_type;

  /*!
   * writes the weights of all control points to `weights[0]`, …, `weights[size() - 1]`. They sum
   * to 1.
   *
   * \tparam T the number type, a `Jet_2`: with the coordinates their derivatives come along, and so
   * come those of the weights. Any number type that the coordinates can be computed in has to do;
   * with an exact one the weights are exact. So does a pack of several numbers of type `double`,
   * `internal::Number_pack`, with which several points are evaluated at once: what depends on a
   * comparison is chosen by `internal::select()`, for each point of its own.
   * \tparam Domain a `Polygonal_domain_2`
   *
   * \param domain the domain, which says what the neighbours of a side are
   * \param lambda the n coordinates
   * \param weights receives the weights
   *
   * \pre `domain.size() == number_of_sides()`
   */
  template <typename T, typename Domain>
  void evaluate(const Domain& domain, const T* lambda, T* weights) const;

  //! the same with memory of the caller's
  template <typename T, typename Domain>
  void evaluate(const Domain& domain, const T* lambda, T* weights, Workspace<T>& workspace) const;

  /*!
   * the sum of all control points times their weights: what `evaluate()` and a product give, up to
   * rounding, but with no need to store the weights.
   *
   * \tparam T, Domain as for `evaluate()`
   * \tparam Point has the coordinates `p[0]`, `p[1]` and `p[2]`, which convert to the number type
   * of `T`
   *
   * \param domain, lambda as for `evaluate()`
   * \param control_net the `size()` control points, in the order of the weights
   */
  template <typename T, typename Domain, typename Point>
  std::array<T, 3> combine(const Domain& domain, const T* lambda,
                           const std::vector<Point>& control_net) const;

  //! the same with memory of the caller's
  template <typename T, typename Domain, typename Point>
  std::array<T, 3> combine(const Domain& domain, const T* lambda,
                           const std::vector<Point>& control_net, Workspace<T>& workspace) const;
};
