#pragma once

#include <blossom/core/maps/patch_map.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/net_sums.hpp>

#include <span>
#include <vector>

namespace blossom {

/// A patch prepared for evaluation at many points: its coefficients as a homogeneous polynomial in the
/// coordinates of each factor, which are the control points times multinomial coefficients. Copies share the
/// prepared data.
///
/// Source: Fernandez-Jambrina, section 2. Statements: fj-tri-def, fj-tensor-matrix.
class PatchValues {
public:
    explicit PatchValues(const BezierPatch& patch, const Limits& limits = {});
    explicit PatchValues(const PolynomialPatch& patch, const Limits& limits = {});

    std::size_t dimension() const { return forms_.rows(); }

    /// The value that `evaluate` gives. Cost: s + 2 multiplications per control point of each factor, and one
    /// multiply-add per control point and coordinate; in words if they provably suffice, otherwise modulo
    /// primes. Errors: `not_affine` for a mass other than 1, `wrong_arity`, `mismatched_dimensions`;
    /// `limit_exceeded`.
    Coordinates operator()(const PatchPoint& point) const;
    /// The values at all points, dimension() coordinates each, one after the other, on `jobs` threads. The
    /// places of errors are below `Part::at / i`.
    std::vector<Rational> at(std::span<const PatchPoint> points, std::size_t jobs = 1) const;
    /// The same in memory that the caller provides. `results` is unspecified after an error. Additional
    /// error: `mismatched_dimensions` unless there are points.size() * dimension() results.
    void at(std::span<const PatchPoint> points, std::span<Rational> results, std::size_t jobs = 1) const;

private:
    enum class Frame { vertices, origin };

    PatchValues(const NetShape& shape, const PointArray& form, const Integer& greatest, Frame frame,
                const Limits& limits);
    void evaluate(const PatchPoint& point, std::span<Rational> value) const;
    void evaluate_any(const PatchPoint& point, std::span<Rational> value) const;

    NetSums forms_;
    Frame frame_;
    Limits limits_;
    bool words_are_within_limits_;
};

}  // namespace blossom
