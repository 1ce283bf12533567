#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/patch/combined_maps.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/integer_polynomials.hpp>

#include <algorithm>
#include <bit>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "blossom/patch_product.hpp"

namespace blossom {

namespace {

using Degrees = std::vector<std::size_t>;

Degrees degrees_of_net(const NetShape& shape) {
    Degrees degrees;
    degrees.reserve(shape.factors());
    for (const SimplexFactor& factor : shape.list()) degrees.push_back(factor.degree);
    return degrees;
}

NetShape with_degrees(const NetShape& shape, std::span<const std::size_t> degrees, const Limits& limits) {
    std::vector<SimplexFactor> factors = shape.list();
    for (std::size_t f = 0; f < factors.size(); ++f) factors[f].degree = degrees[f];
    return NetShape(std::move(factors), limits);
}

/// The coefficients of one coordinate, or of a product of coordinates.
struct FormRow {
    NetShape shape;
    std::vector<Integer> numerators;
    Integer denominator;
};

/// Products of coordinates, each computed once.
class ProductsOfRows {
public:
    ProductsOfRows(std::span<const Form> forms, const Limits& limits) : forms_(forms), limits_(limits) {}

    const FormRow& of(std::vector<CoordinateOf> coordinates) {
        std::ranges::sort(coordinates);
        return of_sorted(coordinates);
    }

private:
    const FormRow& of_sorted(std::span<const CoordinateOf> coordinates) {
        const std::vector<CoordinateOf> key(coordinates.begin(), coordinates.end());
        const auto known = rows_.find(key);
        if (known != rows_.end()) return known->second;
        return rows_.emplace(key, computed(coordinates)).first->second;
    }
    FormRow computed(std::span<const CoordinateOf> coordinates) {
        if (coordinates.empty()) {
            const Degrees none(forms_.front().shape.factors());
            return {with_degrees(forms_.front().shape, none, limits_), {Integer(1)}, 1};
        }
        const auto [map, coordinate] = coordinates.back();
        const Form& form = forms_[map];
        if (coordinates.size() == 1) return {form.shape, form.rows[coordinate], form.denominator};
        const FormRow& left = of_sorted(coordinates.first(coordinates.size() - 1));
        const std::vector<Integer>& right = form.rows[coordinate];
        Integer denominator = left.denominator * form.denominator;
        if (is_segment(left.shape)) {
            NetShape shape = NetShape::segment(left.shape[0].degree + form.shape[0].degree);
            return {std::move(shape), product(left.numerators, right), std::move(denominator)};
        }
        require_within(work_ += left.shape.size() * form.shape.size(), limits_.expansion_work,
                       "expansion_work", "the number of products of coefficients, at least", Part::maps);
        const ProductTable& table = table_for(left.shape, form.shape);
        return {table.shape(), table.product(left.numerators, right), std::move(denominator)};
    }
    static bool is_segment(const NetShape& shape) { return shape.factors() == 1 && shape[0].dimension == 1; }
    const ProductTable& table_for(const NetShape& a, const NetShape& b) {
        const std::pair key(degrees_of_net(a), degrees_of_net(b));
        const auto known = tables_.find(key);
        if (known != tables_.end()) return known->second;
        return tables_.emplace(key, ProductTable(a, b, limits_)).first->second;
    }

    std::span<const Form> forms_;
    const Limits& limits_;
    std::map<std::vector<CoordinateOf>, FormRow> rows_;
    std::map<std::pair<Degrees, Degrees>, ProductTable> tables_;
    std::size_t work_ = 0;
};

/// A sum of rows over their common denominator.
class SumOfRows {
public:
    SumOfRows(NetShape shape, std::size_t dimension)
        : form_{std::move(shape), std::vector(dimension, std::vector<Integer>()), 1} {
        for (auto& row : form_.rows) row.resize(form_.shape.size());
    }

    void add(std::size_t coordinate, std::span<const Integer> numerators, const Rational& factor) {
        const Integer common = lcm(form_.denominator, factor.denominator());
        if (common != form_.denominator) {
            const Integer more = divide_exactly(common, form_.denominator);
            for (auto& row : form_.rows) {
                for (Integer& entry : row) entry *= more;
            }
            form_.denominator = common;
        }
        const Integer multiple = factor.numerator() * divide_exactly(common, factor.denominator());
        std::vector<Integer>& row = form_.rows[coordinate];
        for (std::size_t i = 0; i < row.size(); ++i) row[i].add_product(numerators[i], multiple);
    }

    const Form& form() const { return form_; }

private:
    Form form_;
};

/// The degrees of a product in each factor of the domain, or knots.
template <class DegreesOfMap>
Degrees degrees_of_product(const CoordinateProduct& product, std::size_t factors,
                           const DegreesOfMap& degrees_of_map, const Limits& limits) {
    Degrees degrees(factors);
    for (const CoordinateOf& one : product.coordinates) {
        for (std::size_t f = 0; f < factors; ++f) degrees[f] += degrees_of_map(one.map, f);
    }
    for (const std::size_t degree : degrees)
        require_within(degree, limits.degree, "degree", "the degree of a product", Part::maps);
    return degrees;
}

/// The greatest degrees of the products.
template <class DegreesOfMap>
Degrees degrees_of_sums(std::span<const CoordinateSum> sums, std::size_t factors,
                        const DegreesOfMap& degrees_of_map, const Limits& limits) {
    Degrees greatest(factors);
    for (const CoordinateSum& sum : sums) {
        for (const CoordinateProduct& product : sum) {
            const Degrees degrees = degrees_of_product(product, factors, degrees_of_map, limits);
            for (std::size_t f = 0; f < factors; ++f) greatest[f] = std::max(greatest[f], degrees[f]);
        }
    }
    return greatest;
}

template <class Maps>
void require_maps(const Maps& maps, std::span<const CoordinateSum> sums) {
    if (maps.empty()) throw Error(ErrorCode::wrong_arity, "at least one map is needed", Part::maps);
    if (sums.empty()) throw Error(ErrorCode::wrong_arity, "a map has at least one coordinate", Part::maps);
}

void require_factors_of_first(const NetShape& shape, const NetShape& first, std::size_t map) {
    const auto same_dimension = [](const SimplexFactor& a, const SimplexFactor& b) {
        return a.dimension == b.dimension;
    };
    if (std::ranges::equal(shape.list(), first.list(), same_dimension)) return;
    throw Error(ErrorCode::mismatched_dimensions,
                "map " + std::to_string(map) + " has another kind of domain than map 0", Part::maps / map);
}

template <class Map>
void require_bits(std::span<const Map> maps, std::span<const CoordinateSum> sums, const NetShape& shape,
                  const Limits& limits) {
    std::vector<std::size_t> bits;
    for (const Map& map : maps)
        bits.push_back(bits_of(points_of(map)) + points_of(map).denominator().bit_length());
    std::size_t greatest = 0;
    for (const CoordinateSum& sum : sums) {
        for (const CoordinateProduct& product : sum) {
            std::size_t own = std::bit_width(sum.size());
            for (const CoordinateOf& one : product.coordinates) own += bits[one.map];
            greatest = std::max(greatest, own);
        }
    }
    std::size_t of_degrees = 0;  // binomial and multinomial coefficients in numerators and denominators
    for (const SimplexFactor& factor : shape.list()) {
        of_degrees += 2 * factor.degree * static_cast<std::size_t>(std::bit_width(factor.dimension + 1));
    }
    require_result_bits(greatest + of_degrees, limits, shape.size() * sums.size());
}

}  // namespace

template <PatchRepresentation Map>
Map combined(std::span<const Map> maps, std::span<const CoordinateSum> sums, const Limits& limits) {
    require_maps(maps, sums);
    for (std::size_t i = 0; i < maps.size(); ++i)
        require_factors_of_first(maps[i].shape(), maps[0].shape(), i);
    const auto degree_of_map = [&](std::size_t map, std::size_t f) { return maps[map].shape()[f].degree; };
    const Degrees degrees = degrees_of_sums(sums, maps[0].shape().factors(), degree_of_map, limits);
    const NetShape shape = with_degrees(maps[0].shape(), degrees, limits);
    require_product_within({shape.size(), sums.size()}, limits.numbers, "numbers",
                           "the number of coordinates of the result", Part::maps);
    require_bits(maps, sums, shape, limits);

    std::vector<Form> forms;
    forms.reserve(maps.size());
    for (const Map& map : maps) forms.push_back(form_rows(map));
    ProductsOfRows products(forms, limits);
    std::map<Degrees, SumOfRows> sums_by_degrees;
    for (std::size_t j = 0; j < sums.size(); ++j) {
        for (const CoordinateProduct& product : sums[j]) {
            if (product.factor.is_zero()) continue;
            const FormRow& row = products.of(product.coordinates);
            auto& sum =
                sums_by_degrees.try_emplace(degrees_of_net(row.shape), row.shape, sums.size()).first->second;
            sum.add(j, row.numerators, product.factor / Rational(row.denominator));
        }
    }
    SumOfRows total(shape, sums.size());
    for (const auto& [own, sum] : sums_by_degrees) {
        const Map raised = elevated_to(patch_of<Map>(sum.form()), degrees, limits);
        const PointArray& points = points_of(raised);
        for (std::size_t j = 0; j < sums.size(); ++j)
            total.add(j, points.coordinate(j), Rational(Integer(1), points.denominator()));
    }
    return {shape, canonical_points(total.form().rows, total.form().denominator)};
}

template BezierPatch combined(std::span<const BezierPatch>, std::span<const CoordinateSum>, const Limits&);
template PolynomialPatch combined(std::span<const PolynomialPatch>, std::span<const CoordinateSum>,
                                  const Limits&);

PolynomialCurve combined(std::span<const PolynomialCurve> maps, std::span<const CoordinateSum> sums,
                         const Limits& limits) {
    std::vector<PolynomialPatch> patches;
    for (const PolynomialCurve& curve : maps) patches.push_back(as_patch(curve));
    return PolynomialCurve(combined(std::span<const PolynomialPatch>(patches), sums, limits).coefficients());
}

BezierCurve combined(std::span<const BezierCurve> maps, std::span<const CoordinateSum> sums,
                     const Limits& limits) {
    std::vector<BezierPatch> patches;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (maps[i].interval() != maps[0].interval()) {
            throw Error(ErrorCode::outside_domain,
                        "map " + std::to_string(i) + " is over another interval than map 0", Part::maps / i);
        }
        patches.push_back(as_patch(maps[i]));
    }
    require_maps(maps, sums);
    return {combined(std::span<const BezierPatch>(patches), sums, limits).control_net(), maps[0].interval()};
}

}  // namespace blossom
