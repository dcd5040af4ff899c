// Instructions of aarch64 as GNU's assembler writes them, one of each kind that accesses memory.
#include "common/simt/engine/is_store_aarch64.h"

#include <gtest/gtest.h>

namespace raylab::simt {
namespace {

struct Instruction {
    uint32_t bits;
    const char* name;
};

constexpr Instruction loads[] = {
    {0xf9400020, "ldr"},    {0x39400020, "ldrb"},     {0x39c00020, "ldrsb"}, {0x78e26820, "ldrsh"},
    {0xb9800020, "ldrsw"},  {0x3dc00020, "ldr"},      {0x3ce26820, "ldr"},   {0xf85fd020, "ldur"},
    {0x3cdfd020, "ldur"},   {0xa9400c20, "ldp"},      {0xad400420, "ldp"},   {0x69400c20, "ldpsw"},
    {0xa8400c20, "ldnp"},   {0xc85f7c20, "ldxr"},     {0x885ffc20, "ldaxr"}, {0xc87f0c20, "ldxp"},
    {0x88dffc20, "ldar"},   {0x4c407820, "ld1"},      {0x4cdf0820, "ld4"},   {0x4d40c820, "ld1r"},
    {0x99404020, "ldapur"}, {0x99804020, "ldapursw"},
};
constexpr Instruction stores[] = {
    {0xf9000020, "str"},   {0x39000020, "strb"},  {0x78226820, "strh"},   {0x3d800020, "str"},
    {0x3ca26820, "str"},   {0x3c810420, "str"},   {0xf81fd020, "stur"},   {0x3c9fd020, "stur"},
    {0xa9000c20, "stp"},   {0xad000420, "stp"},   {0xa8000c20, "stnp"},   {0xc8047c20, "stxr"},
    {0x8804fc20, "stlxr"}, {0xc8240c20, "stxp"},  {0x889ffc20, "stlr"},   {0x4c007820, "st1"},
    {0x4c9f0820, "st4"},   {0x99004020, "stlur"}, {0xb8200022, "ldadd"},  {0xf8e00022, "ldaddal"},
    {0xb8208022, "swp"},   {0xf8203022, "ldset"}, {0x88a07c22, "cas"},    {0xc8e0fc22, "casal"},
    {0x48207c82, "casp"},  {0x08a07c22, "casb"},  {0xb8204022, "ldsmax"}, {0xd50b7420, "dc"},
};

TEST(IsStoreAarch64, OfEachKindOfAccess) {
    for (const Instruction& load : loads) EXPECT_FALSE(is_store_aarch64(load.bits)) << load.name;
    for (const Instruction& store : stores) EXPECT_TRUE(is_store_aarch64(store.bits)) << store.name;
}

} // namespace
} // namespace raylab::simt
