#version 460
#extension GL_GOOGLE_include_directive : require
// variants: ONE_TARGET|LIGHT_PAIR|COUNT_TARGET|DEFERRED_TARGET, ADDED, SHADOWS, STENCIL_ROUGHNESS, SAMPLES
// never: COUNT_TARGET SHADOWS, DEFERRED_TARGET STENCIL_ROUGHNESS, SAMPLES COUNT_TARGET, SAMPLES STENCIL_ROUGHNESS
// only: DEFERRED_TARGET ADDED with SAMPLES
// All lights of a tile, summed and written once, for devices that read buffers slowly: each invocation
// of a subgroup loads another light, then all of them take each in turn from their neighbours. A workgroup is
// one of the 8 × 8 blocks of pixels that light_lists_lit.comp found, an invocation `rows` of them. The lights
// come as the tile's list, or (masked) as the bits of its 8 × 8 tiles' list.
// With SAMPLES a workgroup is a tile of the sample light buffer instead: samples of edge pixels, all of one block.
#define STORAGE_TARGET
#include "shared/light_sums.glsl"
#include "shared/light_front.glsl"
#include "shared/light_lists.glsl"
#include "shared/light_share.glsl"
#ifdef SAMPLES
#include "shared/edge_reads.glsl"
#endif

layout(constant_id = CONSTANT_LIST_TILE_SIZE) const int tile_size = 16;
layout(constant_id = CONSTANT_LIST_ROWS) const int rows = 8;
layout(constant_id = CONSTANT_LIST_MASKED) const bool masked = false;
layout(constant_id = CONSTANT_AMBIENT_TOO) const bool ambient_too = false;
layout(set = SET_INPUTS, binding = INPUT_LIT_BLOCKS, std430) readonly buffer LitBlock { LitBlocks lit; uint lit_blocks[]; };
layout(local_size_x = 8, local_size_y_id = CONSTANT_LIST_GROUP_ROWS) in; // times `rows`: 8

LitPixel pixels[rows];
LightSums sums[rows];
uint contributing[rows];
uint evaluated = 0u;
LightFront front;

LightSource shuffled(LightSource mine, uint lane) {
    return LightSource(shuffled(mine.position, lane), shuffled(mine.colour, lane), subgroupShuffle(mine.luminance, lane),
                subgroupShuffle(mine.inverse_range2, lane), shuffled(mine.axis, lane), shuffled(mine.cone, lane),
                subgroupShuffle(mine.shininess, lane), subgroupShuffle(mine.falloff, lane),
                subgroupShuffle(mine.distribution, lane)
#ifdef SHADOWS
                , subgroupShuffle(mine.shadow, lane), subgroupShuffle(mine.shadow_kind, lane), false
#endif
    );
}

// One light from each invocation that has one, and the lanes of those that have.
struct Taken {
    LightSource mine;
    uvec2 lanes;
};

bool none(uvec2 lanes) { return (lanes.x | lanes.y) == 0u; }

// Which lights one walk takes. A software device runs what the shadows of any of them need for all of them.
const int without_maps = 0, maps_around = 1, maps_in_cascades = 2; // around: of points and spots

#ifdef SHADOWS
int maps_of(LightSource source) {
    bool cascades = may_be(LIGHT_KIND_DIRECTIONAL) && source.shadow_kind == SHADOW_CASCADES;
    return source.shadow == 0u ? without_maps : cascades ? maps_in_cascades : maps_around;
}

// The same, with what the walk knows said in constants, so that nothing else is compiled.
LightSource narrowed(LightSource source, const int maps) {
    source.shadow = maps == without_maps ? 0u : source.shadow;
    source.shadow_kind = maps == maps_in_cascades               ? SHADOW_CASCADES
                         : source.shadow_kind == SHADOW_FACES ? SHADOW_FACES
                                                              : SHADOW_SPOT;
    return source;
}

// What of a light comes past its maps to each row, LitPoint::unhidden. A software device compares for all lanes or for
// none, and few pixels of a row need it: so each lane takes the next of its own rows that does, whichever that is.
void find_shadows(LightSource source) {
    Lookup lookups[rows];
    uint asking = 0u;
    for (int row = 0; row < rows; ++row) {
        LitPoint p = pixels[row].point;
        Reach r = reach(source, p);
        ShadowPoint at = shadow_point(source, p, r);
        bool wanted = r.contributes && !is_stored_sun(source, p);
        lookups[row] = lookup(shadow_of(source), at.world, at.n, -at.reach.to_light, at.reach.nl, p.turn, wanted);
        pixels[row].point.unhidden = lookups[row].said;
        asking |= lookups[row].asks ? 1u << row : 0u;
    }
    do {
        int next = max(findLSB(asking), 0);
        Lookup at = lookups[0];
        vec2 turn = pixels[0].point.turn;
        for (int row = 1; row < rows; ++row) { // one by one: it would keep arrays in memory
            bool is = row == next;
            at.tile = is ? lookups[row].tile : at.tile;
            at.place = is ? lookups[row].place : at.place;
            at.radius = is ? lookups[row].radius : at.radius;
            turn = is ? pixels[row].point.turn : turn;
        }
        at.asks = asking != 0u;
        float left = filtered(at, turn);
        for (int row = 0; row < rows; ++row)
            pixels[row].point.unhidden = at.asks && row == next ? left : pixels[row].point.unhidden;
        asking &= asking - 1u;
    } while (asking != 0u);
}
#endif

// The invocation's own light, if it is wanted and before the surfaces; of none, nothing comes.
Taken take(LightData own, bool wanted, const int maps) {
    LightSource mine = light_source(own);
#ifdef SHADOWS
    wanted = wanted && maps_of(mine) == maps;
    mine.shadow = wanted ? mine.shadow : 0u;
#endif
    wanted = wanted && may_be_before(front, own);
    mine.colour = wanted ? mine.colour : vec3(0.0);
    mine.luminance = wanted ? mine.luminance : 0.0;
    uint me = gl_SubgroupInvocationID;
    return Taken(mine, shared_or(wanted ? uvec2(me < 32u ? 1u << me : 0u, me < 32u ? 0u : 1u << (me & 31u)) : uvec2(0u)));
}

// Loops here are left at their end: a software device runs the rest of a body once more for no invocation when
// the condition stands before it, and both sides of an `if`.
void add_lights(Taken taken, const int maps) {
    uvec2 lanes = taken.lanes;
    evaluated += uint(bitCount(lanes.x) + bitCount(lanes.y));
    do {
        bool lower = lanes.x != 0u, real = lower || lanes.y != 0u;
        uint lane = uint(max(findLSB(lower ? lanes.x : lanes.y), 0)) + (lower || !real ? 0u : 32u);
        lanes = lower ? uvec2(lanes.x & (lanes.x - 1u), lanes.y) : uvec2(0u, lanes.y & (lanes.y - 1u));
#ifdef COUNT_TARGET
        if (!real)
            break; // counts know no colour that is 0
#endif
        LightSource source = shuffled(taken.mine, lane);
#ifdef SHADOWS
        source = narrowed(source, maps);
        if (lookups_apart && maps != without_maps) {
            find_shadows(source);
            source.shadow_known = true;
        }
#endif
        for (int row = 0; row < rows; ++row)
            contributing[row] += add_light(sums[row], pixels[row], source) && real ? 1u : 0u;
    } while (!none(lanes));
}

void walk(LightList list, const int maps) {
    uint begin = 0u;
    do {
        Taken taken;
        do { // past lights of other kinds
            uint index = begin + gl_SubgroupInvocationID;
            uint light = listed_light(list, index);
            taken = take(lights[index < list.count ? light : 0u], index < list.count, maps);
            begin += gl_SubgroupSize;
        } while (maps != without_maps && none(taken.lanes) && begin < list.count);
        add_lights(taken, maps);
    } while (begin < list.count);
}

void walk_masked(MaskedList list, const int maps) {
    uint chunk = 0u;
    do {
        uint own_bits = mask_word(list, chunk + gl_SubgroupInvocationID);
        uint last = min(gl_SubgroupSize, list.words - chunk), word = 0u;
        uint bits = subgroupShuffle(own_bits, 0u);
        do {
            Taken taken;
            do { // past lights of other kinds
                uint index = 0u, count = 0u; // of the lights that the invocations take
                do {
                    bool found = bits != 0u;
                    uint next = (chunk + word) * 32u + uint(max(findLSB(bits), 0));
                    index = found && gl_SubgroupInvocationID == count ? next : index;
                    count += found ? 1u : 0u;
                    word += found ? 0u : 1u;
                    bits = found ? bits & (bits - 1u) : subgroupShuffle(own_bits, min(word, gl_SubgroupSize - 1u));
                } while (word < last && count < gl_SubgroupSize);
                uint light = masked_light(list, index);
                bool takes = gl_SubgroupInvocationID < count;
                taken = take(lights[takes ? light : 0u], takes, maps);
            } while (maps != without_maps && none(taken.lanes) && word < last);
            add_lights(taken, maps);
        } while (word < last);
        chunk += gl_SubgroupSize;
    } while (chunk < list.words);
}

void walk_tile(uvec2 tile, const int maps) {
    if (masked)
        walk_masked(masked_list_of(tile), maps);
    else
        walk(list_of(tile.y * lists.cells.x + tile.x, 0u), maps);
}

LightFront front_of_pixels() {
    vec3 n = vec3(0.0);
    for (int row = 0; row < rows; ++row)
        n += pixels[row].point.n;
    n = mean_normal(shared_sum(n));
    vec3 least = vec3(1.0, 1e30, 0.0); // cosine, distance, minus size
    vec3 low = vec3(1e30), minus_high = vec3(1e30);
    for (int row = 0; row < rows; ++row) {
        LitPoint p = pixels[row].point;
        vec3 own = vec3(dot(p.n, n), dot(p.world, n), -dot(abs(p.world), vec3(1.0)));
        least = p.surface ? min(least, own) : least;
        low = p.surface ? min(low, p.world) : low;
        minus_high = p.surface ? min(minus_high, -p.world) : minus_high;
    }
    least = shared_min(least);
    return light_front(n, least.x, least.y, -least.z, shared_min(low), -shared_min(minus_high));
}

// What a workgroup lights: blocks of pixels, or of samples.
struct Block {
    uint number; // of the workgroup
    bool there;  // the dispatch is as wide as its row: past its end nothing is written
    uvec2 place; // in the picture, blocks
};

#ifdef SAMPLES
uint slot_of(int row) { return (gl_LocalInvocationID.y * uint(rows) + uint(row)) * LIT_BLOCK + gl_LocalInvocationID.x; }

// In the picture; outside of it where there is none.
ivec2 pixel_of(Block block, int row) {
    return edge_pixel((block.there ? block.number * TILE_SLOTS : 0u) + slot_of(row), block.place);
}
ivec2 texel_of(Block block, int row) { return edge_texel(block.number * TILE_SLOTS + slot_of(row)); }
#else
ivec2 pixel_of(Block block, int row) {
    return ivec2(block.place) * LIT_BLOCK + ivec2(gl_LocalInvocationID.x, gl_LocalInvocationID.y * uint(rows) + uint(row));
}
ivec2 texel_of(Block block, int row) { return pixel_of(block, row); }
#endif

Block block_of_group() {
    uint number = gl_WorkGroupID.y * LIT_ROW + gl_WorkGroupID.x, count = lit.dispatch.w;
#ifdef SAMPLES
    count = min(count, edge_tiles);
#endif
    uint index = lit_blocks[min(number, max(count, 1u) - 1u)];
    bool there = number < count;
    return Block(number, there, there ? uvec2(index % lists.blocks.x, index / lists.blocks.x) : uvec2(0u));
}

void main() {
    Block block = block_of_group();
    ivec2 last = last_pixel();
    for (int row = 0; row < rows; ++row) {
        ivec2 pixel = pixel_of(block, row);
        pixels[row] = read_pixel(clamp(pixel, ivec2(0), last));
#ifdef SAMPLES
        pixels[row].point.surface = pixels[row].point.surface && pixel.x >= 0;
        pixels[row].point.n = pixel.x >= 0 ? pixels[row].point.n : vec3(0.0);
#endif
        sums[row] = no_light();
        contributing[row] = 0u;
        if (ambient_too && pixels[row].point.surface)
            add_ambient(sums[row]);
    }
    front = front_of_pixels();
    uvec2 tile = block.place / uint(tile_size / LIT_BLOCK);
    walk_tile(tile, without_maps);
#ifdef SHADOWS
    walk_tile(tile, maps_around);
    if (may_be(LIGHT_KIND_DIRECTIONAL))
        walk_tile(tile, maps_in_cascades);
#endif
    for (int row = 0; row < rows; ++row) {
        ivec2 pixel = pixel_of(block, row);
        if (!block.there || pixel.x < 0 || any(greaterThan(pixel, last)))
            continue;
        bool surface = pixels[row].point.surface;
        count_lights(pixel, surface ? evaluated : 0u, contributing[row]);
#if defined(DEFERRED_TARGET) && !defined(SAMPLES)
        if (!surface)
            continue; // stays as it is; elsewhere the sum of nothing takes the place of what was here before
#endif
        write_sums(texel_of(block, row), sums[row]);
    }
}
