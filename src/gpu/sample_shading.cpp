#include "sample_shading.hpp"
#include <algorithm>
#include <initializer_list>
#include <set>

namespace prelight::gpu {
namespace {

// SPIR-V 1.6, sections 2.3 (physical layout) and 3 (binary form).
constexpr size_t header_words = 5;
constexpr uint32_t op_capability = 17, op_variable = 59, op_decorate = 71;
constexpr uint32_t capability_sample_rate_shading = 35;
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

} // namespace prelight::gpu
