#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace hwffd::command {

/// What a subcommand does once its options are read; returns the exit status.
using Action = std::function<int()>;

// Each adds one subcommand with its options.
Action add_deform(CLI::App& app);
Action add_view(CLI::App& app);
Action add_embed(CLI::App& app);
Action add_fit(CLI::App& app);
Action add_lattice(CLI::App& app);
Action add_check(CLI::App& app);
Action add_info(CLI::App& app);
Action add_completion(CLI::App& app);
Action add_manual(CLI::App& app);

}  // namespace hwffd::command
