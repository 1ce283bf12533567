#include <blossom/rational/limits.hpp>

#include <limits>
#include <string>

namespace blossom {

Error limit_error(std::string_view what, std::string_view name, std::size_t limit, const Place& place,
                  std::optional<std::size_t> offset) {
    std::string message(what);
    message.append(" the limit ").append(name).append(" = ").append(std::to_string(limit));
    return Error(ErrorCode::limit_exceeded, std::move(message), place, offset).exceeding(name);
}

void require_within(std::size_t value, std::size_t limit, std::string_view name, std::string_view what,
                    const Place& place) {
    if (value <= limit) return;
    throw limit_error(std::string(what) + " " + std::to_string(value) + " exceeds", name, limit, place);
}

void require_product_within(std::initializer_list<std::size_t> factors, std::size_t limit,
                            std::string_view name, std::string_view what, const Place& place) {
    std::size_t product = 1;
    for (const std::size_t factor : factors) {
        if (__builtin_mul_overflow(product, factor, &product))
            product = std::numeric_limits<std::size_t>::max();
    }
    require_within(product, limit, name, what, place);
}

void require_result_bits(std::size_t bits, const Limits& limits, std::size_t count) {
    // An upper bound, because log10(2) < 0.30103.
    const std::size_t digits = bits / 100'000 * 30'103 + bits % 100'000 * 30'103 / 100'000;
    require_within(digits, limits.digits, "digits", "the size of the result in decimal digits, at most");
    if (digits != 0 && count > limits.output_digits / digits) {
        throw limit_error("a result of " + std::to_string(count) + " numbers of up to " +
                              std::to_string(digits) + " decimal digits exceeds",
                          "output_digits", limits.output_digits);
    }
}

}  // namespace blossom
