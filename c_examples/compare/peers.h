/* Embree in the ways that it is built and asked beside hug. */
#ifndef PEERS_H
#define PEERS_H

#include <embree3/rtcore.h>

/* Its builds, each in a device of its own. */
enum { EMBREE_MEDIUM, EMBREE_ROBUST, EMBREE_LOW, EMBREE_HIGH, EMBREE_COMPACT, EMBREE_BUILDS };

typedef struct {
    const char *name;
    enum RTCBuildQuality quality;
    enum RTCSceneFlags flags;
} embree_kind;

extern const embree_kind embree_kinds[EMBREE_BUILDS];

/* Who is asked: the first is what all ratios are to, and always there. */
enum {
    PEER_REFERENCE,
    PEER_ROBUST,
    PEER_PACKET8,
    PEER_PACKET16,
    PEER_LOW,
    PEER_HIGH,
    PEER_COMPACT,
    PEER_COUNT
};

typedef struct {
    const char *name;
    int build;      /* EMBREE_* */
    unsigned width; /* rays a call: 1, 8 or 16 */
} peer;

extern const peer peers[PEER_COUNT];

/* What --peers calls them, without the reference: bit i is peer i + 1. */
extern const char *const peer_words[PEER_COUNT - 1];

/* Whether a set of peers (bit i: peer i) needs this build. */
int peers_need(unsigned wanted, int build);

#endif
