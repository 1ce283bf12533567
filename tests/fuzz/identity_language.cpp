#include <blossom/proofs/formatter.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

// Any bytes are parsed or refused; the canonical form of a parsed text parses to the same document, and is
// its own canonical form.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace blossom;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const proofs::Document document = proofs::parse(text);
    for (const Error& error : document.errors) {
        if (proofs::diagnostic("text", text, error).empty()) std::abort();
    }
    if (!document.errors.empty()) return 0;
    const std::string canonical = proofs::formatted(document);
    const proofs::Document again = proofs::parse(canonical);
    if (!again.errors.empty() || again.blocks != document.blocks) std::abort();
    if (proofs::formatted(again) != canonical) std::abort();
    return 0;
}
