#pragma once
#include "command_line.hpp"

namespace prelight::app {

// One file a command. Each returns when its work is done; throws Error or UsageError.
void run(const RenderCommand& command);
void run(const SequenceCommand& command);
void run(const ViewCommand& command);
void run(const CompareCommand& command);
void run(const MakeCommand& command);
void run(const InfoCommand& command);
void run(const DevicesCommand& command);
void run(const RenderersCommand& command);
void run(const MaterialsCommand& command);
void run(const BenchCommand& command);
void run(const PrintCommand& command);

} // namespace prelight::app
