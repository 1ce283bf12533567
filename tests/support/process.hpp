#pragma once

#include <string>
#include <vector>

/// Runs a program as a process of its own.

struct Process {
    int status;  ///< the exit status; 128 + the signal when one ended it, as a shell says it
    std::string output;
    std::string errors;
};

/// Runs `command` with /bin/sh in `directory`, with nothing on its standard input.
Process run_shell(const std::string& command, const std::string& directory = ".");

/// The same with a terminal for its standard output, whose bytes are the `output`.
Process run_on_terminal(const std::string& command);

/// A program that is talked to line by line.
class Conversation {
public:
    explicit Conversation(const std::vector<std::string>& arguments);
    Conversation(const Conversation&) = delete;
    Conversation& operator=(const Conversation&) = delete;
    ~Conversation();

    void send(const std::string& text) const;
    /// Waits for a whole line; without its end.
    std::string receive();
    /// Closes the program's standard input and waits for its end.
    int finish();
    /// Closes the reading side of the program's standard output.
    void stop_listening();

private:
    int input_ = -1;
    int output_ = -1;
    int process_ = -1;
    std::string received_;
};
