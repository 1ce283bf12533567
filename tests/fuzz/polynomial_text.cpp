// A text is refused, or it is a polynomial whose own text is read as the same polynomial.

#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/rational/error.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

blossom::Limits small_limits() {
    blossom::Limits limits;
    limits.degree = 30;
    limits.digits = 300;
    limits.nesting = 50;
    limits.expansion_terms = 1 << 10;
    limits.expansion_work = 200'000;
    return limits;
}

/// Names may be so long that the text of a polynomial is much longer than the original text.
constexpr std::size_t longest = 1 << 12;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const blossom::Limits limits = small_limits();
    if (size > longest) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    blossom::NamedPolynomial read;
    try {
        read = blossom::parse_polynomial(text, {}, limits);
    } catch (const blossom::Error& error) {
        if (error.offset() && *error.offset() > size) std::abort();
        return 0;
    }
    const std::string printed = blossom::to_text(read.polynomial, read.names);
    const auto again = blossom::parse_polynomial(printed, read.names);
    if (again.polynomial != read.polynomial) std::abort();
    return 0;
}
