#include "compare/peers.h"

const embree_kind embree_kinds[EMBREE_BUILDS] = {
    {"embree", RTC_BUILD_QUALITY_MEDIUM, RTC_SCENE_FLAG_NONE},
    {"embree_robust", RTC_BUILD_QUALITY_MEDIUM, RTC_SCENE_FLAG_ROBUST},
    {"embree_low", RTC_BUILD_QUALITY_LOW, RTC_SCENE_FLAG_NONE},
    {"embree_high", RTC_BUILD_QUALITY_HIGH, RTC_SCENE_FLAG_NONE},
    {"embree_compact", RTC_BUILD_QUALITY_MEDIUM, RTC_SCENE_FLAG_COMPACT},
};

const peer peers[PEER_COUNT] = {
    {"embree", EMBREE_MEDIUM, 1},
    {"embree_robust", EMBREE_ROBUST, 1},
    {"embree_packet8", EMBREE_MEDIUM, 8},
    {"embree_packet16", EMBREE_MEDIUM, 16},
    {"embree_low", EMBREE_LOW, 1},
    {"embree_high", EMBREE_HIGH, 1},
    {"embree_compact", EMBREE_COMPACT, 1},
};

const char *const peer_words[PEER_COUNT - 1] = {"robust", "packet8", "packet16",
                                                "low",    "high",    "compact"};

int peers_need(unsigned wanted, int build)
{
    int i;
    for (i = 0; i < PEER_COUNT; i++)
        if ((wanted & (1u << i)) && peers[i].build == build)
            return 1;
    return 0;
}
