#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <memory>
#include <span>
#include <vector>

namespace blossom {

/// A curve prepared for evaluation at many parameters: P(t) = p(t, ..., t). Copies share the prepared data.
class CurveValues {
public:
    explicit CurveValues(const PolynomialCurve& curve, const Limits& limits = {});
    /// Prepares the monomial coefficients of the curve. Errors: `limit_exceeded`.
    explicit CurveValues(const BezierCurve& curve, const Limits& limits = {});

    std::size_t dimension() const;

    /// The value that `evaluate` gives. Cost: n multiply-adds in words if they provably suffice, otherwise
    /// products of halves of n h bits, h the bits of t. Errors: `limit_exceeded`.
    Coordinates operator()(const Parameter& t) const;
    /// The values at all parameters, dimension() coordinates each, one after the other, on `jobs` threads.
    std::vector<Rational> at(std::span<const Rational> parameters, std::size_t jobs = 1) const;
    /// The same in memory that the caller provides, whose large numbers are reused. `results` must not
    /// contain a parameter, and is unspecified after an error. Additional error: `mismatched_dimensions`
    /// unless there are parameters.size() * dimension() results.
    void at(std::span<const Rational> parameters, std::span<Rational> results, std::size_t jobs = 1) const;

private:
    friend class SplineValues;
    class Forms;
    std::shared_ptr<const Forms> forms_;
};

/// A B-spline curve prepared in the same way: each segment, at its first use, by its Taylor coefficients at
/// the integer below it.
class SplineValues {
public:
    explicit SplineValues(const BSplineCurve& curve, const Limits& limits = {});

    std::size_t dimension() const;

    /// The value that `de_boor` gives. Cost: a bisection, and n multiply-adds per coordinate once the segment
    /// is prepared. Errors: `outside_domain`, `limit_exceeded`.
    Coordinates operator()(const Parameter& t) const;
    /// The values at all parameters, dimension() coordinates each, one after the other, on `jobs` threads.
    std::vector<Rational> at(std::span<const Rational> parameters, std::size_t jobs = 1) const;
    /// The same in memory that the caller provides, whose large numbers are reused. `results` must not
    /// contain a parameter, and is unspecified after an error. Additional error: `mismatched_dimensions`
    /// unless there are parameters.size() * dimension() results.
    void at(std::span<const Rational> parameters, std::span<Rational> results, std::size_t jobs = 1) const;

private:
    class Segments;
    std::shared_ptr<const Segments> segments_;
};

}  // namespace blossom
