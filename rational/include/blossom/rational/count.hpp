#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

#include <blossom/rational/error.hpp>

namespace blossom {

#ifdef __SIZEOF_INT128__
__extension__ using WideInteger = __int128;
__extension__ using WideUnsigned = unsigned __int128;
template <class Word>
concept WideWord = std::same_as<Word, WideInteger> || std::same_as<Word, WideUnsigned>;
#else
template <class Word>
concept WideWord = false;
#endif

template <class Word>
concept Character = std::same_as<Word, char> || std::same_as<Word, wchar_t> || std::same_as<Word, char8_t> ||
                    std::same_as<Word, char16_t> || std::same_as<Word, char32_t>;

/// The types that are integers without doubt, of any width: neither `bool` nor a character type. `signed
/// char` and `unsigned char` are integers of 8 bits.
template <class Word>
concept WholeNumber =
    WideWord<Word> || (std::integral<Word> && !std::same_as<Word, bool> && !Character<Word>);

/// A number of things, such as a degree, a dimension or an exponent.
///
/// Takes integers of any type that fit in `std::size_t`, and no other type, so that 2.5 or `true` is not
/// silently a degree. Errors: `wrong_kind` for other integers.
class Count {
public:
    template <WholeNumber Word>
    constexpr Count(Word value)  // NOLINT(google-explicit-constructor): an integer is a count
        : value_(static_cast<std::size_t>(value)) {
        if (value < 0) refuse("negative");
        if (static_cast<Word>(value_) != value) refuse("too large");
    }

    constexpr operator std::size_t() const { return value_; }  // NOLINT(google-explicit-constructor)

private:
    [[noreturn]] static void refuse(std::string_view fault) {
        throw Error(ErrorCode::wrong_kind,
                    "a count is " + std::string(fault) + "; it is at least 0 and fits in a word");
    }

    std::size_t value_;
};

/// Errors: `outside_domain` unless `index < size`.
inline void require_index(std::size_t index, std::size_t size) {
    if (index < size) return;
    throw Error(ErrorCode::outside_domain,
                "the index " + std::to_string(index) + " is not below the size " + std::to_string(size));
}

}  // namespace blossom
