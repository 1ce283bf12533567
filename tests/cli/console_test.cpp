// Runs the console examples of the documents: compares the output of every line "$ blossom ..." of a
// ```console block with the block.

#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "support/process.hpp"

namespace {

struct Example {
    std::size_t line;
    std::string command;
    std::string output;
};

/// The commands of the document, each with its output: the lines up to the next command or the end of the
/// block.
std::vector<Example> examples_of(const std::string& path) {
    std::ifstream file(path);
    std::vector<Example> examples;
    bool in_block = false;
    std::size_t number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line.starts_with("```")) {
            in_block = line == "```console";
            continue;
        }
        if (!in_block) continue;
        if (line.starts_with("$ ")) {
            examples.push_back({number, line.substr(2), ""});
        } else if (!examples.empty()) {
            examples.back().output += line + "\n";
        }
    }
    return examples;
}

/// Replaces `scripts/blossom`, which builds the program before it runs it, by the program under test.
std::string with_program(std::string command) {
    const std::string script = "scripts/blossom";
    for (std::size_t at = 0; (at = command.find(script, at)) != std::string::npos;) {
        command.replace(at, script.size(), "blossom");
    }
    return "blossom() { " BLOSSOM_PROGRAM " \"$@\"; }\n" + command;
}

bool shows_blossom(const std::string& command) { return command.find("blossom") != std::string::npos; }

}  // namespace

int main(int argc, char* argv[]) {
    const std::vector<std::string> documents(argv + 1, argv + argc);
    std::size_t compared = 0;
    std::size_t different = 0;
    for (const std::string& document : documents) {
        std::size_t in_document = 0;
        for (const Example& example : examples_of(document)) {
            if (!shows_blossom(example.command)) continue;
            ++in_document;
            const Process run = run_shell(with_program(example.command), BLOSSOM_SOURCE);
            const std::string actual = run.output + run.errors;
            if (actual == example.output) continue;
            ++different;
            std::cout << document << ":" << example.line << ": $ " << example.command << "\n--- shown\n"
                      << example.output << "--- printed\n"
                      << actual;
        }
        if (in_document == 0) {
            ++different;
            std::cout << document << ": no example found\n";
        }
        compared += in_document;
    }
    std::cout << compared << " examples, " << different << " different\n";
    return different == 0 && compared > 0 ? 0 : 1;
}
