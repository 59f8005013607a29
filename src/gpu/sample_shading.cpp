#include "sample_shading.hpp"
#include <algorithm>
#include <initializer_list>
#include <set>
#include <string_view>

namespace prelight::gpu {
namespace {

// SPIR-V 1.6, sections 2.3 (physical layout) and 3 (binary form).
constexpr size_t header_words = 5;
constexpr uint32_t op_extension = 10, op_entry_point = 15, op_execution_mode = 16, op_capability = 17, op_variable = 59,
                   op_decorate = 71;
constexpr uint32_t capability_sample_rate_shading = 35, capability_post_depth_coverage = 4447;
constexpr uint32_t mode_early_fragment_tests = 9, mode_post_depth_coverage = 4446;
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

void add(std::vector<uint32_t>& out, uint32_t op, std::span<const uint32_t> operands) {
    out.push_back(static_cast<uint32_t>(operands.size() + 1) << 16 | op);
    out.insert(out.end(), operands.begin(), operands.end());
}

void add(std::vector<uint32_t>& out, uint32_t op, std::initializer_list<uint32_t> operands) {
    add(out, op, std::span(operands.begin(), operands.size()));
}

/// A literal string: its bytes from the lowest of each word on, and at least one 0.
std::vector<uint32_t> literal(std::string_view text) {
    std::vector<uint32_t> words(text.size() / 4 + 1);
    for (size_t i = 0; i < text.size(); ++i)
        words[i / 4] |= static_cast<uint32_t>(static_cast<unsigned char>(text[i])) << (8 * (i % 4));
    return words;
}

} // namespace

std::vector<uint32_t> with_sample_inputs(std::span<const uint32_t> code) {
    std::set<uint32_t> inputs, kept; // kept: flat ones, and those that are per sample by themselves
    bool capable = false;
    each_instruction(code, [&](uint32_t op, std::span<const uint32_t> words) {
        if (op == op_variable && words[3] == storage_input)
            inputs.insert(words[2]);
        if (op == op_decorate && (words[2] == decoration_flat || words[2] == decoration_sample))
            kept.insert(words[1]);
        capable |= op == op_capability && words[1] == capability_sample_rate_shading;
    });
    std::vector<uint32_t> out(code.begin(), code.begin() + std::min(header_words, code.size()));
    each_instruction(code, [&](uint32_t op, std::span<const uint32_t> words) {
        out.insert(out.end(), words.begin(), words.end());
        if (op == op_capability && !capable) {
            add(out, op_capability, {capability_sample_rate_shading});
            capable = true;
        }
        // Built-in inputs have no location.
        if (op == op_decorate && words[2] == decoration_location && inputs.contains(words[1]) &&
            !kept.contains(words[1]))
            add(out, op_decorate, {words[1], decoration_sample});
    });
    return out;
}

std::vector<uint32_t> with_post_depth_coverage(std::span<const uint32_t> code) {
    std::vector<uint32_t> out(code.begin(), code.begin() + std::min(header_words, code.size()));
    bool capable = false, in_modes = false;
    uint32_t main = 0;
    each_instruction(code, [&](uint32_t op, std::span<const uint32_t> words) {
        if (op != op_capability && !capable) { // capabilities come first, then extensions
            add(out, op_capability, {capability_post_depth_coverage});
            add(out, op_extension, literal("SPV_KHR_post_depth_coverage"));
            capable = true;
        }
        if (op == op_entry_point)
            main = words[2];
        if (op == op_execution_mode && words[2] == mode_early_fragment_tests)
            return;
        if (op == op_execution_mode && !in_modes) {
            add(out, op_execution_mode, {main, mode_early_fragment_tests});
            add(out, op_execution_mode, {main, mode_post_depth_coverage});
            in_modes = true;
        }
        out.insert(out.end(), words.begin(), words.end());
    });
    return out;
}

} // namespace prelight::gpu
