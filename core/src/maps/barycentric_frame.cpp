#include <blossom/core/maps/barycentric_frame.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace blossom {

namespace {

std::string listed(std::span<const std::size_t> numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        text += (i == 0 ? "" : i + 1 == numbers.size() ? " and " : ", ") + std::to_string(numbers[i]);
    }
    return text;
}

[[noreturn]] void refuse_length(const std::string& what, std::size_t given, std::size_t needed,
                                const Place& place) {
    throw Error(ErrorCode::mismatched_dimensions,
                what + " has " + std::to_string(given) + " coordinates, not " + std::to_string(needed),
                place);
}

void require_one_dimension(const std::vector<Coordinates>& vertices) {
    if (vertices.empty())
        throw Error(ErrorCode::wrong_arity, "a simplex needs at least one vertex", Part::vertices);
    const std::size_t dimension = vertices.front().size();
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        if (vertices[k].size() == dimension) continue;
        refuse_length("vertex " + std::to_string(k), vertices[k].size(), dimension, Part::vertices / k);
    }
}

/// The tuple (mass, u).
Coordinates homogeneous(std::span<const Rational> u, const Rational& mass) {
    Coordinates tuple{mass};
    tuple.insert(tuple.end(), u.begin(), u.end());
    return tuple;
}

Rational product_sum(const Coordinates& row, const Coordinates& tuple) {
    Rational sum;
    for (std::size_t i = 0; i < row.size(); ++i) sum += row[i] * tuple[i];
    return sum;
}

/// The rows that map the homogeneous vertices to the unit vectors, by Gauss-Jordan elimination: row k gives
/// the coordinate of vertex k.
std::vector<Coordinates> inverse_of(const std::vector<Coordinates>& vertices) {
    const std::size_t size = vertices.front().size() + 1;
    std::vector<Coordinates> rows(size, Coordinates(size));
    for (std::size_t i = 0; i < size; ++i) rows[i][i] = 1;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const Coordinates vertex = homogeneous(vertices[k], 1);
        Coordinates image;
        for (const Coordinates& row : rows) image.push_back(product_sum(row, vertex));
        std::size_t pivot = k;
        while (pivot < size && image[pivot].is_zero()) ++pivot;
        if (pivot == size) {
            std::vector<std::size_t> dependent;
            for (std::size_t i = 0; i < k; ++i) {
                if (!image[i].is_zero()) dependent.push_back(i);
            }
            dependent.push_back(k);
            throw Error(ErrorCode::degenerate_simplex,
                        dependent.size() == 2
                            ? "the vertices " + listed(dependent) + " are the same point"
                            : "the vertices " + listed(dependent) + " are affinely dependent",
                        Part::vertices / k);
        }
        std::swap(rows[k], rows[pivot]);
        std::swap(image[k], image[pivot]);
        for (Rational& entry : rows[k]) entry /= image[k];
        for (std::size_t i = 0; i < size; ++i) {
            if (i == k || image[i].is_zero()) continue;
            for (std::size_t j = 0; j < size; ++j) rows[i][j] -= image[i] * rows[k][j];
        }
    }
    return rows;
}

std::vector<Coordinates> standard_vertices(std::size_t dimension) {
    std::vector<Coordinates> vertices(dimension + 1, Coordinates(dimension));
    for (std::size_t k = 1; k <= dimension; ++k) vertices[k][k - 1] = 1;
    return vertices;
}

}  // namespace

BarycentricFrame::BarycentricFrame(std::vector<Coordinates> vertices) : vertices_(std::move(vertices)) {
    require_one_dimension(vertices_);
    inverse_ = inverse_of(vertices_);
}

BarycentricFrame BarycentricFrame::standard(std::size_t dimension) {
    return BarycentricFrame(standard_vertices(dimension));
}

Coordinates BarycentricFrame::of_argument(std::span<const Rational> u, const Rational& mass) const {
    if (u.size() != space_dimension())
        refuse_length("a point or vector of the space", u.size(), space_dimension(), {});
    const Coordinates tuple = homogeneous(u, mass);
    Coordinates coordinates;
    for (const Coordinates& row : inverse_) {
        Rational coordinate = product_sum(row, tuple);
        if (coordinates.size() < vertices_.size()) {
            coordinates.push_back(std::move(coordinate));
        } else if (!coordinate.is_zero()) {
            throw Error(ErrorCode::outside_domain,
                        "the point or vector does not lie in the affine hull of the " +
                            std::to_string(vertices_.size()) + " vertices");
        }
    }
    return coordinates;
}

Coordinates BarycentricFrame::of_point(std::span<const Rational> point) const {
    return of_argument(point, 1);
}

Coordinates BarycentricFrame::of_vector(std::span<const Rational> vector) const {
    return of_argument(vector, 0);
}

Coordinates BarycentricFrame::combination(std::span<const Rational> coordinates) const {
    if (coordinates.size() != vertices_.size()) {
        refuse_length("a list of barycentric coordinates", coordinates.size(), vertices_.size(), {});
    }
    Coordinates sum(space_dimension());
    for (std::size_t k = 0; k < vertices_.size(); ++k) {
        for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += coordinates[k] * vertices_[k][j];
    }
    return sum;
}

}  // namespace blossom
