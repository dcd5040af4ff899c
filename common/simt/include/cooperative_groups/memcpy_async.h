// Copies by cooperative groups.
#pragma once

#include "cooperative_groups.h"

#include "common/simt/groups/memcpy_async.h"
