#pragma once

// Numbers of FLINT from those of the engine.

#include <blossom/rational/rational_vector.hpp>

#include <flint/fmpq.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>

#include <span>
#include <string>
#include <vector>

namespace flint_peer {

inline void set(fmpz_t to, const blossom::Integer& value) { fmpz_set_str(to, to_string(value).c_str(), 10); }

/// A vector of fmpz that its destructor clears.
class Integers {
public:
    explicit Integers(slong size) : entries_(_fmpz_vec_init(size)), size_(size) {}
    explicit Integers(std::span<const blossom::Integer> values)
        : Integers(static_cast<slong>(values.size())) {
        for (slong i = 0; i < size_; ++i) set(at(i), values[static_cast<std::size_t>(i)]);
    }
    Integers(const Integers&) = delete;
    Integers& operator=(const Integers&) = delete;
    ~Integers() { _fmpz_vec_clear(entries_, size_); }
    fmpz* data() const { return entries_; }
    fmpz* at(slong i) const { return entries_ + i; }
    slong size() const { return size_; }

private:
    fmpz* entries_;
    slong size_;
};

/// Arguments p/q.
class Arguments {
public:
    explicit Arguments(std::span<const blossom::Rational> values)
        : entries_(_fmpq_vec_init(static_cast<slong>(values.size()))),
          size_(static_cast<slong>(values.size())) {
        for (slong i = 0; i < size_; ++i) {
            set(fmpq_numref(entries_ + i), values[static_cast<std::size_t>(i)].numerator());
            set(fmpq_denref(entries_ + i), values[static_cast<std::size_t>(i)].denominator());
        }
    }
    Arguments(const Arguments&) = delete;
    Arguments& operator=(const Arguments&) = delete;
    ~Arguments() { _fmpq_vec_clear(entries_, size_); }
    fmpq* data() const { return entries_; }
    slong size() const { return size_; }

private:
    fmpq* entries_;
    slong size_;
};

inline std::string text_of(const fmpz_t value) {
    char* digits = fmpz_get_str(nullptr, 10, value);
    std::string result = digits;
    flint_free(digits);
    return result;
}

inline std::string text_of(const fmpq_t value) {
    const std::string numerator = text_of(fmpq_numref(value));
    return fmpz_is_one(fmpq_denref(value)) ? numerator : numerator + "/" + text_of(fmpq_denref(value));
}

}  // namespace flint_peer
