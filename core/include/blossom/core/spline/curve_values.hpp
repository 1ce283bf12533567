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

/// A curve prepared to be evaluated at many parameters: P(t) = p(t, ..., t). Copies share what was prepared.
class CurveValues {
public:
    explicit CurveValues(const PolynomialCurve& curve, const Limits& limits = {});
    /// By its monomial coefficients. Errors: `limit_exceeded`.
    explicit CurveValues(const BezierCurve& curve, const Limits& limits = {});

    std::size_t dimension() const;

    /// The same as `evaluate`. Cost: n multiply-adds in words while they provably suffice, and products of
    /// halves of n h bits, h the bits of t, beyond. Errors: `limit_exceeded`.
    Coordinates operator()(const Parameter& t) const;
    /// The values at all parameters, dimension() coordinates each, one after the other, on `jobs` threads.
    std::vector<Rational> at(std::span<const Rational> parameters, std::size_t jobs = 1) const;
    /// The same into memory of the caller, whose large numbers are reused. `results` holds none of the
    /// parameters, and is unspecified after an error of a value. Errors as well: `mismatched_dimensions`
    /// unless there are parameters.size() * dimension() results.
    void at(std::span<const Rational> parameters, std::span<Rational> results, std::size_t jobs = 1) const;

private:
    friend class SplineValues;
    class Forms;
    std::shared_ptr<const Forms> forms_;
};

/// A B-spline curve prepared in the same way: each of its segments, when it is first asked for, by its Taylor
/// coefficients at the integer below the segment.
class SplineValues {
public:
    explicit SplineValues(const BSplineCurve& curve, const Limits& limits = {});

    std::size_t dimension() const;

    /// The same as `de_boor`. Cost: a bisection and n multiply-adds a coordinate once the segment is
    /// prepared. Errors: `outside_domain`, `limit_exceeded`.
    Coordinates operator()(const Parameter& t) const;
    /// The values at all parameters, dimension() coordinates each, one after the other, on `jobs` threads.
    std::vector<Rational> at(std::span<const Rational> parameters, std::size_t jobs = 1) const;
    /// The same into memory of the caller, whose large numbers are reused. `results` holds none of the
    /// parameters, and is unspecified after an error of a value. Errors as well: `mismatched_dimensions`
    /// unless there are parameters.size() * dimension() results.
    void at(std::span<const Rational> parameters, std::span<Rational> results, std::size_t jobs = 1) const;

private:
    class Segments;
    std::shared_ptr<const Segments> segments_;
};

}  // namespace blossom
