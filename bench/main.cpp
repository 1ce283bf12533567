// The engine compared with expert code for FLINT and with textbook loops on Boost's rational numbers,
// interleaved in one process. All sides are checked to give the same result before they are timed.
//
//     bench_values [--quick] [--only WORK] [--degree N] [--bits N]    rows of CSV, see Report::header
//     bench_values --case N BITS    coefficients, arguments and the value, for peers that are processes
//     bench_values --growth [WORK]  times at degrees 50 to 800 and the exponents, as a table in Markdown
//     bench_values --kernels        which kernel is chosen when

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/rational/blossom_sums.hpp>

#include <cstdio>
#include <cstdlib>

#include "cases.hpp"
#include "families.hpp"

namespace {

int usage() {
    std::fprintf(stderr,
                 "usage: bench_values [--quick] [--only WORK] [--degree N] [--bits N]\n"
                 "       bench_values --case N BITS\n"
                 "       bench_values --growth [WORK]\n"
                 "       bench_values --kernels\n");
    return 64;
}

std::size_t number_in(const char* text) { return std::strtoul(text, nullptr, 10); }

int print_kernels() {
    for (const blossom::SumKernelRule& rule : blossom::sum_kernel_rules())
        std::printf("%-10s %s\n", std::string(rule.name).c_str(), std::string(rule.condition).c_str());
    return 0;
}

int print_case(const Case& given) {
    for (const auto& coefficient : given.coefficients) std::printf("%s ", to_string(coefficient).c_str());
    std::printf("\n");
    for (const auto& argument : given.arguments) std::printf("%s ", to_string(argument).c_str());
    const auto value = blossom::Blossom(curve_of(given)).coordinate(0, arguments_of(given));
    std::printf("\n%s\n", to_string(value).c_str());
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 1 && words[0] == "--kernels") return print_kernels();
    if (words.size() == 3 && words[0] == "--case")
        return print_case(make_case(number_in(argv[2]), number_in(argv[3])));
    if (!words.empty() && words.size() <= 2 && words[0] == "--growth") {
        measure_growth(words.size() == 2 ? words[1] : "");
        return 0;
    }
    Report::Selection selection;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--quick") {
            selection.quick = true;
            continue;
        }
        if (i + 1 == words.size()) return usage();
        const std::string& value = words[i + 1];
        if (words[i] == "--only") {
            selection.work = value;
        } else if (words[i] == "--degree") {
            selection.degree = number_in(value.c_str());
        } else if (words[i] == "--bits") {
            selection.bits = number_in(value.c_str());
        } else {
            return usage();
        }
        ++i;
    }
    const Report report(selection);
    std::printf("%s\n", Report::header);
    measure_values(report);
    measure_constructions(report);
    measure_operations(report);
    measure_curves(report);
    measure_evaluation(report);
    measure_splines(report);
    measure_agreement(report);
    measure_patches(report);
    measure_threads(report);
    measure_machine(report);
    return 0;
}
