// A special-purpose program from simdjson and FLINT: it answers four kinds of requests, line by line, with
// the same responses as `blossom batch`. Requests are not validated.
//
//     request_peer < REQUESTS > RESPONSES

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz.h>
#include <flint/fmpz_vec.h>
#include <simdjson.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using simdjson::ondemand::object;
using simdjson::ondemand::value;

/// Rational numbers over one common denominator.
class Numbers {
public:
    Numbers() { fmpz_init_set_ui(denominator, 1); }
    Numbers(const Numbers&) = delete;
    Numbers& operator=(const Numbers&) = delete;
    ~Numbers() {
        _fmpz_vec_clear(numerators, static_cast<slong>(capacity_));
        fmpz_clear(denominator);
    }

    std::size_t size = 0;
    fmpz* numerators = nullptr;
    fmpz_t denominator;

    void resize(std::size_t count) {
        if (count > capacity_) {
            fmpz* const more = _fmpz_vec_init(static_cast<slong>(2 * count));
            if (numerators) {
                _fmpz_vec_set(more, numerators, static_cast<slong>(size));
                _fmpz_vec_clear(numerators, static_cast<slong>(capacity_));
            }
            numerators = more;
            capacity_ = 2 * count;
        }
        size = count;
    }

private:
    std::size_t capacity_ = 0;
};

void set_text(fmpz* number, const char* first, const char* last) {
    const bool negative = first != last && *first == '-';
    if (last - first > 18) {
        fmpz_set_str(number, std::string(first, last).c_str(), 10);
        return;
    }
    slong small = 0;
    for (const char* digit = first + (negative ? 1 : 0); digit != last; ++digit)
        small = 10 * small + (*digit - '0');
    fmpz_set_si(number, negative ? -small : small);
}

void read_number(std::string_view text, fmpq_t number) {
    const char* const end = text.data() + text.size();
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        set_text(fmpq_numref(number), text.data(), end);
        fmpz_one(fmpq_denref(number));
        return;
    }
    set_text(fmpq_numref(number), text.data(), text.data() + slash);
    set_text(fmpq_denref(number), text.data() + slash + 1, end);
    fmpq_canonicalise(number);
}

class Program {
public:
    Program() {
        fmpq_init(number_);
        fmpq_init(result_);
        fmpz_init(scratch_);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() {
        fmpq_clear(number_);
        fmpq_clear(result_);
        fmpz_clear(scratch_);
    }

    void answer(std::string& line) {
        line.reserve(line.size() + simdjson::SIMDJSON_PADDING);
        auto document = parser_.iterate(line.data(), line.size(), line.capacity());
        object request = document.get_object();
        out += "{\"id\": ";
        out += std::string_view(request["id"].raw_json_token());
        while (out.back() == ' ' || out.back() == ',') out.pop_back();
        out += ", \"ok\": true, \"result\": {";
        const std::string_view op = request["op"];
        if (op == "blossom") {
            read_list(request["map"]["coefficients"], coefficients_);
            read_arguments(request["arguments"]);
            blossom();
        } else if (op == "control-points") {
            read_list(request["map"]["coefficients"], coefficients_);
            control_points();
        } else if (op == "derivative") {
            read_list(request["map"]["coefficients"], coefficients_);
            derivative(request["at"]);
        } else {
            read_list(request["map"]["coefficients"], coefficients_);
            values(request["at"]);
        }
        out += "}}\n";
        if (out.size() > (1 << 16)) flush();
    }

    void flush() {
        std::fwrite(out.data(), 1, out.size(), stdout);
        out.clear();
    }

private:
    void write(const fmpq_t value) {
        char text[64];
        const bool is_short =
            fmpz_sizeinbase(fmpq_numref(value), 10) + fmpz_sizeinbase(fmpq_denref(value), 10) < 60;
        char* const written = fmpq_get_str(is_short ? text : nullptr, 10, value);
        out += '"';
        out += written;
        out += '"';
        if (!is_short) flint_free(written);
    }

    void read_list(simdjson::simdjson_result<value> list, Numbers& numbers) {
        texts_.clear();
        for (auto element : list.get_array()) texts_.push_back(element.get_string());
        numbers.resize(texts_.size());
        fractions_.resize(texts_.size());
        fmpz_one(numbers.denominator);
        for (std::size_t i = 0; i < texts_.size(); ++i) {
            if (i >= initialised_) fmpq_init(&fractions_[i]), ++initialised_;
            read_number(texts_[i], &fractions_[i]);
            fmpz_lcm(numbers.denominator, numbers.denominator, fmpq_denref(&fractions_[i]));
        }
        for (std::size_t i = 0; i < texts_.size(); ++i) {
            fmpz_divexact(scratch_, numbers.denominator, fmpq_denref(&fractions_[i]));
            fmpz_mul(numbers.numerators + i, fmpq_numref(&fractions_[i]), scratch_);
        }
    }

    /// prod (v_i + u_i X) for the arguments u_i / v_i, and prod v_i as its denominator.
    void read_arguments(simdjson::simdjson_result<value> list) {
        fmpz_one(product_.denominator);
        product_.resize(1);
        fmpz_one(product_.numerators);
        for (auto element : list.get_array()) {
            read_number(element.get_string(), number_);
            const std::size_t n = product_.size;
            product_.resize(n + 1);
            fmpz* const p = product_.numerators;
            fmpz_mul(p + n, p + n - 1, fmpq_numref(number_));
            for (std::size_t k = n - 1; k > 0; --k) {
                fmpz_mul(p + k, p + k, fmpq_denref(number_));
                fmpz_addmul(p + k, p + k - 1, fmpq_numref(number_));
            }
            fmpz_mul(p, p, fmpq_denref(number_));
            fmpz_mul(product_.denominator, product_.denominator, fmpq_denref(number_));
        }
    }

    /// sum_k c_k e_k / C(n, k), over lcm_k C(n, k).
    void blossom() {
        const slong n = static_cast<slong>(coefficients_.size) - 1;
        binomials(n);
        fmpz_zero(fmpq_numref(result_));
        for (slong k = 0; k <= n; ++k) {
            fmpz_mul(scratch_, coefficients_.numerators + k, product_.numerators + k);
            fmpz_divexact(fmpq_denref(result_), binomials_.denominator, binomials_.numerators + k);
            fmpz_addmul(fmpq_numref(result_), scratch_, fmpq_denref(result_));
        }
        fmpz_mul(fmpq_denref(result_), coefficients_.denominator, product_.denominator);
        fmpz_mul(fmpq_denref(result_), fmpq_denref(result_), binomials_.denominator);
        fmpq_canonicalise(result_);
        out += "\"value\": ";
        write(result_);
    }

    void binomials(slong n) {
        if (binomials_.size == static_cast<std::size_t>(n) + 1) return;
        binomials_.resize(static_cast<std::size_t>(n) + 1);
        fmpz_one(binomials_.denominator);
        for (slong k = 0; k <= n; ++k) {
            fmpz_bin_uiui(binomials_.numerators + k, static_cast<ulong>(n), static_cast<ulong>(k));
            fmpz_lcm(binomials_.denominator, binomials_.denominator, binomials_.numerators + k);
        }
    }

    /// Control points over [0, 1]: P_j = sum_k C(j, k) c_k / C(n, k), by differences.
    void control_points() {
        const slong n = static_cast<slong>(coefficients_.size) - 1;
        binomials(n);
        fmpz* const points = coefficients_.numerators;
        for (slong k = 0; k <= n; ++k) {
            fmpz_divexact(scratch_, binomials_.denominator, binomials_.numerators + k);
            fmpz_mul(points + k, points + k, scratch_);
        }
        for (slong i = 1; i <= n; ++i) {
            for (slong k = n; k >= i; --k) fmpz_add(points + k, points + k, points + k - 1);
        }
        fmpz_mul(scratch_, coefficients_.denominator, binomials_.denominator);
        out += "\"map\": {\"kind\": \"bezier\", \"degree\": " + std::to_string(n) +
               ", \"interval\": [\"0\", \"1\"], \"control_points\": [";
        for (slong k = 0; k <= n; ++k) {
            fmpq_set_fmpz_frac(result_, points + k, scratch_);
            if (k > 0) out += ", ";
            write(result_);
        }
        out += "]}";
    }

    void derivative(simdjson::simdjson_result<value> list) {
        const slong n = static_cast<slong>(coefficients_.size) - 1;
        for (slong k = 1; k <= n; ++k)
            fmpz_mul_si(coefficients_.numerators + k - 1, coefficients_.numerators + k, k);
        coefficients_.size = static_cast<std::size_t>(n);
        values(list);
    }

    void values(simdjson::simdjson_result<value> list) {
        out += "\"values\": [";
        bool first = true;
        for (auto element : list.get_array()) {
            read_number(element.get_string(), number_);
            _fmpq_poly_evaluate_fmpq(fmpq_numref(result_), fmpq_denref(result_), coefficients_.numerators,
                                     coefficients_.denominator, static_cast<slong>(coefficients_.size),
                                     fmpq_numref(number_), fmpq_denref(number_));
            if (!first) out += ", ";
            first = false;
            write(result_);
        }
        out += ']';
    }

    simdjson::ondemand::parser parser_;
    std::string out;
    std::vector<std::string_view> texts_;
    std::vector<fmpq> fractions_;
    std::size_t initialised_ = 0;
    Numbers coefficients_;
    Numbers product_;
    Numbers binomials_;
    fmpq_t number_;
    fmpq_t result_;
    fmpz_t scratch_;
};

}  // namespace

int main() {
    std::ios::sync_with_stdio(false);
    Program program;
    for (std::string line; std::getline(std::cin, line);) program.answer(line);
    program.flush();
}
