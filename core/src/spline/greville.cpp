#include <blossom/core/spline/greville.hpp>
#include <blossom/rational/error.hpp>

namespace blossom {

std::vector<Rational> greville_abscissae(const KnotVector& knots) {
    if (knots.degree() == 0) {
        throw Error(ErrorCode::degree_too_low,
                    "the map t needs degree 1, so that degree 0 has no Greville abscissae", Part::degree);
    }
    std::vector<Rational> abscissae;
    abscissae.reserve(knots.points());
    for (std::size_t j = 0; j < knots.points(); ++j) {
        Rational sum;
        for (const Rational& knot : knots.window(j)) sum += knot;
        abscissae.push_back(sum / Rational(knots.degree()));
    }
    return abscissae;
}

}  // namespace blossom
