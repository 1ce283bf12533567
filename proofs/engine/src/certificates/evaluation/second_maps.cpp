#include "second_maps.hpp"

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <utility>

namespace blossom::proofs::second {

namespace {

void add_monomials(std::size_t left, std::vector<std::size_t>& exponents, std::size_t coordinate,
                   Direction& direction, const Limits& limits) {
    if (coordinate == exponents.size()) {
        require_within(direction.monomials.size() + 1, limits.numbers / 16, "numbers",
                       "coefficients of a map");
        direction.places.emplace(exponents, direction.monomials.size());
        direction.monomials.push_back(exponents);
        return;
    }
    for (std::size_t exponent = 0; exponent <= left; ++exponent) {
        exponents[coordinate] = exponent;
        add_monomials(left - exponent, exponents, coordinate + 1, direction, limits);
    }
    exponents[coordinate] = 0;
}

}  // namespace

std::size_t Direction::place(const std::vector<std::size_t>& exponents) const {
    return dimension == 1 ? exponents.front() : places.at(exponents);
}

std::size_t MapShape::size() const {
    std::size_t product = 1;
    for (const Direction& direction : directions) product *= direction.monomials.size();
    return product;
}

std::vector<std::size_t> MapShape::exponents(std::size_t place) const {
    std::vector<std::size_t> found;
    std::size_t rest = size();
    for (const Direction& direction : directions) {
        rest /= direction.monomials.size();
        const std::vector<std::size_t>& own = direction.monomials[place / rest];
        found.insert(found.end(), own.begin(), own.end());
        place %= rest;
    }
    return found;
}

std::string MapShape::suffix(std::size_t place) const {
    std::string text;
    for (const std::size_t exponent : exponents(place)) text += "." + std::to_string(exponent);
    return text;
}

Direction direction_of(std::size_t dimension, std::size_t degree, const Limits& limits) {
    Direction direction;
    direction.dimension = dimension;
    direction.degree = degree;
    if (dimension == 1) {
        for (std::size_t exponent = 0; exponent <= degree; ++exponent)
            direction.monomials.push_back({exponent});
        return direction;
    }
    std::vector<std::size_t> exponents(dimension, 0);
    add_monomials(degree, exponents, 0, direction, limits);
    return direction;
}

Rational multinomial(std::size_t degree, const std::vector<std::size_t>& exponents) {
    Integer product = 1;
    for (const std::size_t exponent : exponents) {
        product *= binomial(degree, exponent);
        degree -= exponent;
    }
    return product;
}

MapShape shape_of_map(const Reading& reading, std::uint32_t map, Counting& counting) {
    const MapDeclaration& declaration = reading.maps()[map];
    const Limits& limits = reading.limits();
    Scope none;
    std::vector<std::size_t> degrees;
    degrees.reserve(declaration.degrees.size());
    for (const NodeId degree : declaration.degrees) {
        degrees.push_back(counting.count(degree, none, limits.degree, "a degree"));
    }
    MapShape shape;
    if (declaration.kind == MapDeclaration::Kind::raised) {
        const MapShape source = shape_of_map(reading, declaration.source, counting);
        if (source.directions.size() != degrees.size()) {
            throw Error(ErrorCode::wrong_arity,
                        "the raised map has " + std::to_string(source.directions.size()) + " directions", {},
                        declaration.offset);
        }
        for (std::size_t i = 0; i < degrees.size(); ++i) {
            if (degrees[i] < source.directions[i].degree) {
                throw Error(ErrorCode::degree_too_low, "a map is raised to a degree below its own", {},
                            declaration.offset);
            }
            shape.directions.push_back(direction_of(source.directions[i].dimension, degrees[i], limits));
        }
        return shape;
    }
    std::size_t dimension = 1;
    if (declaration.dimension) {
        dimension = counting.count(*declaration.dimension, none, limits.variables, "a dimension");
    } else if (declaration.kind == MapDeclaration::Kind::polynomial && degrees.size() == 1) {
        dimension = declaration.variables.size();
    }
    std::size_t size = 1;
    for (const std::size_t degree : degrees) {
        shape.directions.push_back(direction_of(dimension, degree, limits));
        size *= shape.directions.back().monomials.size();
        require_within(size, limits.numbers / 16, "numbers", "coefficients of a map");
    }
    return shape;
}

}  // namespace blossom::proofs::second
