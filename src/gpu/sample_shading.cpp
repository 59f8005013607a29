#include "sample_shading.hpp"
#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <set>
#include <string_view>

namespace prelight::gpu {
namespace {

// SPIR-V 1.6, sections 2.3 (physical layout), 2.4 (order of instructions) and 3 (binary form).
constexpr size_t header_words = 5;
constexpr uint32_t op_extension = 10, op_entry_point = 15, op_execution_mode = 16, op_capability = 17, op_variable = 59,
                   op_decorate = 71;
constexpr uint32_t capability_sample_rate_shading = 35, capability_post_depth_coverage = 4447;
constexpr uint32_t mode_early_tests = 9, mode_post_depth_coverage = 4446;
constexpr uint32_t decoration_flat = 14, decoration_sample = 17, decoration_location = 30;
constexpr uint32_t storage_input = 1;

/// Calls `visit` with each instruction's opcode and words.
template <class Visit>
void each_instruction(std::span<const uint32_t> code, Visit&& visit) {
    for (size_t at = header_words; at < code.size();) {
        const size_t words = std::max<size_t>(code[at] >> 16, 1);
        visit(code[at] & 0xffffu, code.subspan(at, std::min(words, code.size() - at)));
        at += words;
    }
}

void add(std::vector<uint32_t>& out, uint32_t op, std::initializer_list<uint32_t> operands) {
    out.push_back(static_cast<uint32_t>(operands.size() + 1) << 16 | op);
    out.insert(out.end(), operands);
}

void add_extension(std::vector<uint32_t>& out, std::string_view name) {
    const size_t words = name.size() / 4 + 1; // with its zero
    out.push_back(static_cast<uint32_t>(words + 1) << 16 | op_extension);
    out.resize(out.size() + words);
    std::memcpy(&out[out.size() - words], name.data(), name.size());
}

struct Shader {
    std::set<uint32_t> inputs, kept; ///< kept: flat ones, and those that are per sample by themselves
    std::set<uint32_t> has;          ///< capabilities
    bool early_tests = false;
};

Shader read(std::span<const uint32_t> code) {
    Shader shader;
    each_instruction(code, [&](uint32_t op, std::span<const uint32_t> words) {
        if (op == op_variable && words[3] == storage_input)
            shader.inputs.insert(words[2]);
        if (op == op_decorate && (words[2] == decoration_flat || words[2] == decoration_sample))
            shader.kept.insert(words[1]);
        if (op == op_capability)
            shader.has.insert(words[1]);
        shader.early_tests |= op == op_execution_mode && words[2] == mode_early_tests;
    });
    return shader;
}

} // namespace

std::vector<uint32_t> with_sample_shading(std::span<const uint32_t> code, SampleShading shading) {
    const Shader shader = read(code);
    const bool sample = shading == SampleShading::sample, owned = shading == SampleShading::owned_fragment;
    std::vector<uint32_t> out(code.begin(), code.begin() + std::min(header_words, code.size()));
    bool capabilities = true;
    each_instruction(code, [&](uint32_t op, std::span<const uint32_t> words) {
        if (capabilities && op != op_capability) { // they come first, extensions next
            capabilities = false;
            if (sample && !shader.has.contains(capability_sample_rate_shading))
                add(out, op_capability, {capability_sample_rate_shading});
            if (owned) {
                add(out, op_capability, {capability_post_depth_coverage});
                add_extension(out, "SPV_KHR_post_depth_coverage");
            }
        }
        // Entry points stand together, and before all modes.
        const bool mode = owned && op == op_entry_point;
        out.insert(out.end(), words.begin(), words.end());
        if (mode) {
            if (!shader.early_tests)
                add(out, op_execution_mode, {words[2], mode_early_tests});
            add(out, op_execution_mode, {words[2], mode_post_depth_coverage});
        }
        // Built-in inputs have no location.
        if (sample && op == op_decorate && words[2] == decoration_location && shader.inputs.contains(words[1]) &&
            !shader.kept.contains(words[1]))
            add(out, op_decorate, {words[1], decoration_sample});
    });
    return out;
}

} // namespace prelight::gpu
