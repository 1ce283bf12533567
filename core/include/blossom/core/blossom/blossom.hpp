#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/polynomial_map.hpp>
#include <blossom/rational/limits.hpp>

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace blossom {

/// The ways to compute a blossom: the three constructions, where polarization has two forms. One evaluates
/// every term, the other combines the terms with equal numbers of points.
enum class Construction { symmetric, polarization, regrouped_polarization, casteljau };

/// The word of the protocol for a construction, for instance "casteljau".
std::string_view construction_name(Construction construction);

/// The homogeneous blossom (polar form) of a polynomial map of formal degree n: the symmetric map of n
/// arguments, linear in each pair (u, v), with p((t,1), ..., (t,1)) = P(t). Points have mass 1, vectors mass
/// 0.
///
/// The first two values are computed from the map directly. From the third value on a prepared form is used,
/// which costs about as much as three values at low degree and makes each of them up to five times as fast.
/// An object may be used by any number of threads at once. Values at points are points; each vector among the
/// arguments lowers the mass of the value, and a value of mass 0 is a vector (a derivative). Source: Goldman,
/// section 4.1; Ramshaw's multiplicative view. Statements: goldman-haxioms, goldman-thm6.
class Blossom {
public:
    explicit Blossom(PolynomialMap map, Limits limits = {});
    explicit Blossom(PolynomialCurve curve, Limits limits = {})
        : Blossom(PolynomialMap(std::move(curve)), limits) {}
    explicit Blossom(BezierCurve curve, Limits limits = {})
        : Blossom(PolynomialMap(std::move(curve)), limits) {}

    std::size_t degree() const { return degree_; }
    std::size_t dimension() const { return dimension_; }

    /// p(arguments) by the formula that suits the representation: elementary symmetric functions for monomial
    /// coefficients, the Bernstein sum of DeRose, section 4.2, for a control polygon.
    ///
    /// Cost: n^2 / 2 multiply-adds on integers, then n and one reduction per coordinate. For n <= 64 and
    /// numbers of one word only the result is allocated. Errors: `wrong_arity` unless there are n arguments;
    /// `limit_exceeded`.
    Coordinates operator()(std::span<const Argument> arguments) const;
    Coordinates operator()(std::initializer_list<Argument> arguments) const {
        return (*this)(std::span<const Argument>(arguments.begin(), arguments.size()));
    }

    /// Coordinate j < dimension() of p(arguments).
    Rational coordinate(std::size_t j, std::span<const Argument> arguments) const;

    /// The values at many tuples of n arguments, dimension() coordinates each, one after the other.
    ///
    /// Cost: that of the single values, and less if words hold all numbers; on `jobs` threads.
    /// Errors: `wrong_arity`; `limit_exceeded`.
    std::vector<Rational> values(std::span<const std::vector<Argument>> tuples, std::size_t jobs = 1) const;
    /// The same in memory that the caller provides, for repeated calls; if words hold all numbers, nothing is
    /// allocated. `results` must not contain an argument, and is unspecified after `limit_exceeded`.
    ///
    /// Additional error: `mismatched_dimensions` unless there are tuples.size() * dimension() results.
    void values(std::span<const std::vector<Argument>> tuples, std::span<Rational> results,
                std::size_t jobs = 1) const;

private:
    struct Kernel;
    struct Shared;

    /// Computes the coordinates from row `first` on.
    void evaluate(std::span<const Argument> arguments, std::size_t first,
                  std::span<Rational> coordinates) const;

    std::size_t degree_;
    std::size_t dimension_;
    std::shared_ptr<const Shared> shared_;  ///< by all copies
};

/// A single value p(arguments), computed as by a `Blossom`. If words hold all numbers, nothing is copied and
/// only the result is allocated.
///
/// Errors: those of `Blossom`.
Coordinates blossom_value(const PolynomialCurve& curve, std::span<const Argument> arguments,
                          const Limits& limits = {});
Coordinates blossom_value(const BezierCurve& curve, std::span<const Argument> arguments,
                          const Limits& limits = {});

/// p(arguments) by the given construction, each from its own data: symmetric functions from monomial
/// coefficients, polarization from values of the map alone, de Casteljau from control points (over [0, 1] for
/// a `PolynomialCurve`).
///
/// Cost: see `constructions`, and a change of basis, O(n^2), if the construction needs another
/// representation. Errors: `wrong_arity`; `limit_exceeded`, for polarization if prod(m_i + 1) exceeds
/// `polarization_terms`, and for the regrouped form if n^2 (n + 1)^2 / 4 exceeds `regrouping_work`.
Coordinates blossom_value(const PolynomialMap& map, std::span<const Argument> arguments,
                          Construction construction, const Limits& limits = {});

/// The polarization inverse formula for any map that can be evaluated:
/// b[t_1..t_n] = (1/n!) sum_N (-1)^(n-N) N^n sum b(mean of N of the t_i), and the constant b(0) for n = 0.
///
/// The result is the blossom if `map` is a polynomial of degree at most n; otherwise it is an approximation
/// that interpolates on the diagonal and is not multiaffine. Cost: prod(m_i + 1) - 1 calls of `map`, m_i the
/// multiplicities. Errors: `limit_exceeded`. Source: Fernandez-Jambrina, equation (20). Statements: fj-cor1,
/// fj-cost, fj-reduction-not-multiaffine.
Coordinates blossom_from_values(const std::function<Coordinates(const Rational&)>& map,
                                std::span<const Parameter> arguments, const Limits& limits = {});

}  // namespace blossom
