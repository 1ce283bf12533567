#include "point_algebra.hpp"

#include "certificates/evaluation/second_counting.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <utility>

namespace blossom::proofs::second {

AlgebraNumber::AlgebraNumber(std::vector<Rational> coordinates) {
    while (!coordinates.empty() && coordinates.back().is_zero()) coordinates.pop_back();
    if (coordinates.empty()) return;
    constant_ = std::move(coordinates.front());
    coordinates.erase(coordinates.begin());
    rest_ = std::move(coordinates);
}

std::vector<Rational> AlgebraNumber::coordinates() const {
    std::vector<Rational> all{constant_};
    all.insert(all.end(), rest_.begin(), rest_.end());
    return all;
}

void Algebra::add_level(LevelKind kind, std::size_t degree, std::vector<AlgebraNumber> relation) {
    const std::size_t size = size_below(levels_.size()) * degree;
    require_within(size, limits_.numbers / 64, "numbers", "the dimension of an algebra");
    levels_.push_back({kind, degree, size, std::move(relation)});
}

AlgebraNumber Algebra::adjoin_nilpotent(std::size_t degree) {
    add_level(LevelKind::nilpotent, degree, {});
    if (degree == 1) return {};
    return joined({AlgebraNumber(), AlgebraNumber(Rational(1))}, levels_.size() - 1);
}

std::vector<AlgebraNumber> Algebra::adjoin_first_order(std::size_t count) {
    add_level(LevelKind::first_order, count + 1, {});
    std::vector<AlgebraNumber> generators;
    for (std::size_t i = 1; i <= count; ++i) {
        std::vector<AlgebraNumber> parts(i + 1);
        parts.back() = Rational(1);
        generators.push_back(joined(parts, levels_.size() - 1));
    }
    return generators;
}

AlgebraNumber Algebra::adjoin_root(std::vector<AlgebraNumber> lower_coefficients) {
    const std::size_t degree = lower_coefficients.size();
    add_level(LevelKind::root, degree, std::move(lower_coefficients));
    if (degree == 1) return negative(levels_.back().relation.front());
    return joined({AlgebraNumber(), AlgebraNumber(Rational(1))}, levels_.size() - 1);
}

std::size_t Algebra::level_of(std::size_t size) const {
    std::size_t level = 0;
    while (levels_[level].size < size) ++level;
    return level;
}

std::vector<AlgebraNumber> Algebra::parts(const AlgebraNumber& value) const {
    return parts_at(value, levels_.size() - 1);
}

std::vector<AlgebraNumber> Algebra::parts_at(const AlgebraNumber& value, std::size_t level) const {
    const std::size_t below = size_below(level);
    std::vector<AlgebraNumber> parts(levels_[level].degree);
    for (std::size_t i = 0; i < parts.size() && i * below < value.size(); ++i) {
        const std::size_t end = std::min(value.size(), (i + 1) * below);
        if (below == 1) {
            parts[i] = value[i];
            continue;
        }
        std::vector<Rational> coordinates;
        for (std::size_t k = i * below; k < end; ++k) coordinates.push_back(value[k]);
        parts[i] = AlgebraNumber(std::move(coordinates));
    }
    return parts;
}

AlgebraNumber Algebra::joined(const std::vector<AlgebraNumber>& parts, std::size_t level) const {
    const std::size_t below = size_below(level);
    std::vector<Rational> coordinates(parts.size() * below);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t k = 0; k < parts[i].size(); ++k) coordinates[i * below + k] = parts[i][k];
    }
    return AlgebraNumber(std::move(coordinates));
}

AlgebraNumber Algebra::sum(const AlgebraNumber& a, const AlgebraNumber& b) const {
    if (a.size() < b.size()) return sum(b, a);
    AlgebraNumber result = a;
    result.constant_ += b.constant_;
    for (std::size_t i = 0; i < b.rest_.size(); ++i) result.rest_[i] += b.rest_[i];
    while (!result.rest_.empty() && result.rest_.back().is_zero()) result.rest_.pop_back();
    return result;
}

AlgebraNumber Algebra::difference(const AlgebraNumber& a, const AlgebraNumber& b) const {
    return sum(a, negative(b));
}

AlgebraNumber Algebra::negative(AlgebraNumber a) const {
    a.constant_ = -std::move(a.constant_);
    for (Rational& coordinate : a.rest_) coordinate = -std::move(coordinate);
    return a;
}

AlgebraNumber Algebra::scaled(AlgebraNumber a, const Rational& factor) const {
    if (factor.is_zero()) return {};
    require_short_product(a.constant_, factor, limits_);
    a.constant_ *= factor;
    for (Rational& coordinate : a.rest_) {
        if (!coordinate.is_zero()) coordinate *= factor;
    }
    return a;
}

AlgebraNumber Algebra::product(const AlgebraNumber& a, const AlgebraNumber& b) const {
    if (b.is_rational()) return scaled(a, b.constant_);
    if (a.is_rational()) return scaled(b, a.constant_);
    require_short_product(a.constant_, b.constant_, limits_);
    work_ += a.size() * b.size();
    require_within(work_, limits_.expansion_work, "expansion_work", "the work at one point");
    constexpr std::uint64_t words_of_operation = 64;
    spend_work(words_of_operation * a.size() * b.size());
    return product_at(a, b, level_of(std::max(a.size(), b.size())));
}

AlgebraNumber Algebra::product_at(const AlgebraNumber& a, const AlgebraNumber& b, std::size_t level) const {
    const Level& top = levels_[level];
    const std::size_t below = size_below(level);
    if (top.kind == LevelKind::nilpotent && below == 1) return rational_nilpotent_product(a, b, top.degree);
    if (a.size() <= below || b.size() <= below) {
        const AlgebraNumber& small = a.size() <= below ? a : b;
        std::vector<AlgebraNumber> parts = parts_at(a.size() <= below ? b : a, level);
        for (AlgebraNumber& part : parts) part = product(part, small);
        return joined(parts, level);
    }
    const std::vector<AlgebraNumber> left = parts_at(a, level);
    const std::vector<AlgebraNumber> right = parts_at(b, level);
    if (top.kind != LevelKind::first_order) return joined(power_parts(left, right, level), level);
    std::vector<AlgebraNumber> parts(top.degree);
    parts[0] = product(left[0], right[0]);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        if (!left[i].is_zero()) parts[i] = product(left[i], right[0]);
        if (!right[i].is_zero()) parts[i] = sum(parts[i], product(left[0], right[i]));
    }
    return joined(parts, level);
}

AlgebraNumber Algebra::rational_nilpotent_product(const AlgebraNumber& a, const AlgebraNumber& b,
                                                  std::size_t degree) const {
    std::vector<Rational> coordinates(std::min(degree, a.size() + b.size() - 1));
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].is_zero()) continue;
        for (std::size_t k = 0; k < b.size() && i + k < coordinates.size(); ++k) {
            if (!b[k].is_zero()) coordinates[i + k] += a[i] * b[k];
        }
    }
    return AlgebraNumber(std::move(coordinates));
}

std::vector<AlgebraNumber> Algebra::power_parts(const std::vector<AlgebraNumber>& a,
                                                const std::vector<AlgebraNumber>& b,
                                                std::size_t level) const {
    const Level& top = levels_[level];
    const bool is_root = top.kind == LevelKind::root;
    std::vector<AlgebraNumber> parts(is_root ? 2 * top.degree - 1 : top.degree);
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].is_zero()) continue;
        for (std::size_t k = 0; k < b.size() && i + k < parts.size(); ++k) {
            if (!b[k].is_zero()) parts[i + k] = sum(parts[i + k], product(a[i], b[k]));
        }
    }
    while (parts.size() > top.degree) {
        const AlgebraNumber leading = std::move(parts.back());
        parts.pop_back();
        if (leading.is_zero()) continue;
        const std::size_t first = parts.size() - top.degree;
        for (std::size_t i = 0; i < top.degree; ++i) {
            parts[first + i] = difference(parts[first + i], product(leading, top.relation[i]));
        }
    }
    return parts;
}

AlgebraNumber Algebra::power(const AlgebraNumber& a, std::size_t exponent) const {
    if (a.is_rational()) return integer_power(a.constant_, Rational(exponent), limits_, 0);
    AlgebraNumber result(Rational(1));
    AlgebraNumber square = a;
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1) result = product(result, square);
        if (exponent > 1) square = product(square, square);
    }
    return result;
}

AlgebraNumber Algebra::quotient(const AlgebraNumber& a, const AlgebraNumber& b) const {
    return product(a, inverse(b));
}

AlgebraNumber Algebra::inverse(const AlgebraNumber& a) const {
    if (a.is_rational()) return Rational(1) / a.constant_;
    const std::size_t level = level_of(a.size());
    inverted_ = std::max(inverted_, level + 1);
    return levels_[level].kind == LevelKind::root ? inverse_by_system(a, level) : inverse_by_series(a, level);
}

AlgebraNumber Algebra::inverse_by_series(const AlgebraNumber& a, std::size_t level) const {
    const std::vector<AlgebraNumber> own = parts_at(a, level);
    std::vector<AlgebraNumber> parts(own.size());
    parts[0] = inverse(own[0]);
    if (levels_[level].kind == LevelKind::first_order) {
        const AlgebraNumber square = negative(product(parts[0], parts[0]));
        for (std::size_t i = 1; i < own.size(); ++i) parts[i] = product(square, own[i]);
        return joined(parts, level);
    }
    for (std::size_t k = 1; k < own.size(); ++k) {
        AlgebraNumber total;
        for (std::size_t i = 1; i <= k; ++i) total = sum(total, product(own[i], parts[k - i]));
        parts[k] = negative(product(total, parts[0]));
    }
    return joined(parts, level);
}

// Solves a x == 1 for x: column k of the matrix is a times the k-th element of the basis.
AlgebraNumber Algebra::inverse_by_system(const AlgebraNumber& a, std::size_t level) const {
    const std::size_t size = levels_[level].size;
    require_within(size, 256, "numbers", "the dimension of an algebra with roots");
    std::vector<std::vector<Rational>> rows(size, std::vector<Rational>(size + 1));
    rows[0][size] = Rational(1);
    for (std::size_t column = 0; column < size; ++column) {
        std::vector<Rational> unit(column + 1);
        unit.back() = Rational(1);
        const AlgebraNumber image = product(a, AlgebraNumber(std::move(unit)));
        for (std::size_t row = 0; row < image.size(); ++row) rows[row][column] = image[row];
    }
    for (std::size_t column = 0; column < size; ++column) {
        std::size_t pivot = column;
        while (pivot < size && rows[pivot][column].is_zero()) ++pivot;
        if (pivot == size) throw Error(ErrorCode::division_by_zero, "a divisor of zero cannot be divided by");
        std::swap(rows[pivot], rows[column]);
        for (std::size_t k = size + 1; k-- > column;) rows[column][k] /= rows[column][column];
        for (std::size_t row = 0; row < size; ++row) {
            const Rational factor = rows[row][column];
            if (row == column || factor.is_zero()) continue;
            for (std::size_t k = column; k <= size; ++k) rows[row][k] -= factor * rows[column][k];
        }
    }
    std::vector<Rational> solution;
    solution.reserve(size);
    for (const std::vector<Rational>& row : rows) solution.push_back(row[size]);
    return AlgebraNumber(std::move(solution));
}

}  // namespace blossom::proofs::second
