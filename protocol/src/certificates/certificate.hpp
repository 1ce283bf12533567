#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <string>
#include <vector>

/// Values of blossoms as a file that Coq checks with the theorems of proofs/coq.

namespace blossom::protocol {

/// One claim: name = multiple * p[arguments] = value, p being the homogeneous blossom of a map.
struct CertifiedValue {
    std::string name;
    std::vector<Argument> arguments;  ///< as many as the formal degree of the map
    Integer multiple;
    Coordinates value;
};

/// Claims about one map, given by its coefficients.
struct CertifiedMap {
    PolynomialCurve curve;
    std::vector<CertifiedValue> values;
};

/// What is claimed in answer to one request.
struct Certificate {
    std::string title;
    std::vector<CertifiedMap> maps;
};

/// The Coq file: for each certificate its numbers in a comment, the same numbers as a stream of machine
/// words, and the theorem that what they say is true, which Coq checks by computation with integers alone.
///
/// The integers are those of `proofs/coq/stream.v`: denominators are cleared by the homogeneity of the
/// blossom, (u, v) = (u', v') / w, so that no division is left to check.
/// Cost: n numbers per value and coordinate. Errors: `limit_exceeded` for more than `limits.numbers` numbers
/// or `limits.output_digits` digits.
std::string coq_file(std::span<const Certificate> certificates, const Limits& limits);

}  // namespace blossom::protocol
