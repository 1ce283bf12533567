#pragma once

// Number theoretic transforms on one part of residue vectors, two layers of butterflies per pass.

#include "residue_lanes.hpp"

namespace blossom::residues {

template <class Level>
class Transform {
public:
    Transform(const Moduli& moduli, const ResidueVector* roots, std::size_t part)
        : constants_(moduli, part), roots_(roots), part_(part) {}

    /// Decimation in frequency: the values are in bit-reversed order.
    void forward(ResidueVector* a, std::size_t size) const {
        if (size > most_at_once) {
            forward_layers(a, size, size / 4);
            for (std::size_t i = 0; i < 4; ++i) forward(a + i * (size / 4), size / 4);
            return;
        }
        std::size_t length = size;
        for (; length >= 4; length /= 4) forward_layers(a, size, length / 4);
        if (length == 2) last_layer(a, size);
    }

    /// The inverse layers in reverse order.
    void backward(ResidueVector* a, std::size_t size) const {
        if (size > most_at_once) {
            for (std::size_t i = 0; i < 4; ++i) backward(a + i * (size / 4), size / 4);
            backward_layers(a, size, size / 4);
            return;
        }
        const bool has_odd_layer = __builtin_ctzll(size) % 2 == 1;
        if (has_odd_layer) last_layer(a, size);
        for (std::size_t q = has_odd_layer ? 2 : 1; 4 * q <= size; q *= 4) backward_layers(a, size, q);
    }

private:
    using Vector = typename Level::Vector;

    /// The number of residue vectors that stay in the nearest cache; longer transforms are split in four.
    static constexpr std::size_t most_at_once = 256;

    Vector load(const ResidueVector& from) const { return Level::load(from, part_); }
    void store(ResidueVector& to, const Vector& value) const { Level::store(to, part_, value); }
    Vector sum(const Vector& a, const Vector& b) const { return Level::sum(constants_, a, b); }
    Vector difference(const Vector& a, const Vector& b) const { return Level::difference(constants_, a, b); }
    Vector product(const Vector& a, std::size_t root) const {
        return Level::product(constants_, a, load(roots_[root]));
    }
    Vector product_of_difference(const Vector& a, const Vector& b, std::size_t root) const {
        return Level::product_of_difference(constants_, a, b, load(roots_[root]));
    }

    /// The layer of adjacent elements, whose root is 1. It is its own inverse.
    void last_layer(ResidueVector* a, std::size_t size) const {
        for (std::size_t k = 0; k < size; k += 2) {
            const Vector x = load(a[k]);
            const Vector y = load(a[k + 1]);
            store(a[k], sum(x, y));
            store(a[k + 1], difference(x, y));
        }
    }

    /// The layers of distances 2 q and q.
    void forward_layers(ResidueVector* a, std::size_t size, std::size_t q) const {
        for (ResidueVector* block = a; block < a + size; block += 4 * q) {
            for (std::size_t i = 0; i < q; ++i) {
                ResidueVector* const x = block + i;
                const Vector x0 = load(x[0]);
                const Vector x1 = load(x[q]);
                const Vector x2 = load(x[2 * q]);
                const Vector x3 = load(x[3 * q]);
                const Vector y0 = sum(x0, x2);
                const Vector y1 = sum(x1, x3);
                const Vector y2 = product_of_difference(x0, x2, 2 * q + i);
                const Vector y3 = product_of_difference(x1, x3, 3 * q + i);
                store(x[0], sum(y0, y1));
                store(x[q], product_of_difference(y0, y1, q + i));
                store(x[2 * q], sum(y2, y3));
                store(x[3 * q], product_of_difference(y2, y3, q + i));
            }
        }
    }

    /// The inverse layers of distances q and 2 q. The inverse of power i > 0 of a root of order 2 h is the
    /// negative of power h - i, so that sums and differences are exchanged.
    void backward_layers(ResidueVector* a, std::size_t size, std::size_t q) const {
        for (ResidueVector* x = a; x < a + size; x += 4 * q) {
            const Vector y0 = sum(load(x[0]), load(x[q]));
            const Vector y1 = difference(load(x[0]), load(x[q]));
            const Vector y2 = sum(load(x[2 * q]), load(x[3 * q]));
            const Vector y3 = product(difference(load(x[2 * q]), load(x[3 * q])), 3 * q);
            store(x[0], sum(y0, y2));
            store(x[2 * q], difference(y0, y2));
            store(x[q], difference(y1, y3));
            store(x[3 * q], sum(y1, y3));
            for (std::size_t i = 1; i < q; ++i) backward_step(x + i, q, i);
        }
    }
    void backward_step(ResidueVector* x, std::size_t q, std::size_t i) const {
        const Vector x0 = load(x[0]);
        const Vector x1 = product(load(x[q]), 2 * q - i);
        const Vector x2 = load(x[2 * q]);
        const Vector x3 = product(load(x[3 * q]), 2 * q - i);
        const Vector y0 = difference(x0, x1);
        const Vector y1 = sum(x0, x1);
        const Vector y2 = product(difference(x2, x3), 4 * q - i);
        const Vector y3 = product(sum(x2, x3), 3 * q - i);
        store(x[0], difference(y0, y2));
        store(x[2 * q], sum(y0, y2));
        store(x[q], difference(y1, y3));
        store(x[3 * q], sum(y1, y3));
    }

    typename Level::Constants constants_;
    const ResidueVector* roots_;
    std::size_t part_;
};

}  // namespace blossom::residues
