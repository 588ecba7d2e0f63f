/*!
 * \ingroup PkgMultisidedPatchesConcepts
 * \cgalConcept
 *
 * Generalized barycentric coordinates on a `Polygonal_domain_2` with n vertices: functions
 * λ_0, …, λ_{n-1} with Σ λ_i = 1, Σ λ_i v_i = (u,v) and λ_i(v_j) = δ_ij, linear on every side.
 *
 * An object is immutable after construction, and all its members may be called from several threads
 * at once. It owns what it needs: neither the domain given to its constructor nor anything else has
 * to outlive it.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Multisided_patches::Wachspress_coordinates_2}
 * \cgalHasModels{CGAL::Multisided_patches::Mean_value_coordinates_2}
 * \cgalHasModels{CGAL::Multisided_patches::Harmonic_coordinates_2}
 * \cgalHasModels{CGAL::Multisided_patches::IO::Any_coordinates_2}
 * \cgalHasModelsEnd
 */
class BarycentricCoordinates_2 {
public:
  //! a CGAL kernel with exact predicates
  using Geom_traits = unspecified_type;
  using FT = Geom_traits::FT;
  using Point_2 = Geom_traits::Point_2;
  using Domain = Polygonal_domain_2<Geom_traits>;
  using Location = Domain_location<FT>;

  /*!
   * computes the coordinates of a domain. A patch constructs its coordinates in this way.
   *
   * \throws Input_error if the coordinates do not exist on this domain
   */
  explicit BarycentricCoordinates_2(const Domain& domain);

  const Domain& domain() const;

  /*!
   * writes the values and the partial derivatives up to `Order` (0, 1 or 2) of the n coordinates at
   * `p` to `lambda[0]`, …, `lambda[n - 1]`.
   *
   * `location` says where `p` lies, as `domain().locate(p)` does; a caller who knows need not ask
   * again. On a side the values are exactly 1 - location.s, location.s and 0, at a vertex exactly 1
   * and 0. Derivatives there are the limits from the inside, where these exist; each model says
   * what it returns where they do not.
   *
   * \pre `location.kind != Location::Kind::outside`
   */
  template <int Order>
  void evaluate(const Point_2& p, const Location& location, Jet_2<FT, Order>* lambda) const;

  /*!
   * the same at (`u`, `v`) in another number type. Optional: only the evaluation of a patch in
   * other number types asks for it, and each model says with which types it compiles.
   */
  template <int Order, typename Real>
  void evaluate(const Real& u, const Real& v, const Domain_location<Real>& location,
                Jet_2<Real, Order>* lambda) const;

  /*!
   * writes the n values at `p` to `out` and returns one past the last element written.
   *
   * \throws Outside_domain_error if `p` lies outside the closed domain
   */
  template <typename OutputIterator>
  OutputIterator operator()(const Point_2& p, OutputIterator out) const;
};
