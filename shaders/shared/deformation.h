// Skins and morph targets on the device: what deform.comp is told of one primitive, and how its buffers are laid out.
#ifndef PRELIGHT_DEFORMATION_H
#define PRELIGHT_DEFORMATION_H
#include "shared/interop.h"
SHARED_BEGIN

#define DEFORM_GROUP 64
#define DEFORM_ROW 65535 // groups of a dispatch along x

#define DEFORM_BASE_FLOATS 10      // of a vertex at rest: position, normal, tangent
#define DEFORM_INFLUENCE_WORDS 6   // of a vertex in one set: four joints of 16 bits, four weights
#define DEFORM_TARGET_FLOATS 9     // of a vertex in one morph target: what it adds to position, normal, tangent
#define DEFORM_ATTRIBUTE_FLOATS 13 // of a vertex's attributes: normal, tangent, then what stays

#define DEFORM_TANGENTS 1 // it has tangents
#define DEFORM_FLAT 2     // normals are the triangles' own, of vertices 3i, 3i + 1, 3i + 2
#define DEFORM_TURNED 4   // the joints mirror
#define DEFORM_PREVIOUS 8 // previous positions are wanted

struct DeformJob {
    uvec4 vertices; // first to write, how many, first at rest, flags
    uvec4 data;     // where influences begin (words), sets of them, where targets begin (floats), how many
    uvec4 state;    // where the state begins (vec4): three rows of each joint, the same of the previous joints, weights
                    // of targets four to a vec4, previous weights; y: joints; z: vertices of the primitive;
                    // w: vec4 of weights
};

SHARED_END
#endif
