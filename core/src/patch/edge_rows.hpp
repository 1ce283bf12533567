#pragma once

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>

#include <cstddef>
#include <vector>

/// A net over a triangle near its edge from vertex 0 to vertex 1.

namespace blossom {

/// The points of the edge, and the derivatives there in the direction from vertex 0 to vertex 2, as
/// polynomials in t, which runs from 0 to 1 along the edge.
class EdgeRows {
public:
    explicit EdgeRows(const BezierPatch& net) : degree_(net.shape()[0].degree) {
        for (std::size_t k = 0; k <= degree_; ++k) {
            edge_.push_back(point(net, {degree_ - k, k, 0}));
            if (k < degree_) next_.push_back(point(net, {degree_ - 1 - k, k, 1}));
        }
    }

    std::vector<Polynomial> points() const { return polynomials(edge_); }
    std::vector<Polynomial> along() const { return polynomials(differences(edge_)); }
    std::vector<Polynomial> across() const { return polynomials(differences(next_)); }

private:
    static Coordinates point(const BezierPatch& net, const MultiIndex& index) {
        return net.control_net()[position(index)];
    }
    /// n times the differences from the points of the edge: point k of the edge itself moved by one, or of
    /// the next row.
    std::vector<Coordinates> differences(const std::vector<Coordinates>& to) const {
        if (degree_ == 0) return {Coordinates(edge_.front().size())};
        const std::size_t moved = to.size() == edge_.size() ? 1 : 0;
        std::vector<Coordinates> vectors;
        for (std::size_t k = 0; k < degree_; ++k) {
            Coordinates& vector = vectors.emplace_back(to[k + moved]);
            for (std::size_t j = 0; j < vector.size(); ++j)
                vector[j] = Rational(degree_) * (vector[j] - edge_[k][j]);
        }
        return vectors;
    }
    static std::vector<Polynomial> polynomials(const std::vector<Coordinates>& points) {
        return coordinates_of(monomial_form(BezierCurve(points, Interval())));
    }

    std::size_t degree_;
    std::vector<Coordinates> edge_;
    std::vector<Coordinates> next_;
};

}  // namespace blossom
