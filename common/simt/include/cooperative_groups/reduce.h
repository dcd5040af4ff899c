// Reductions over cooperative groups.
#pragma once

#include "cooperative_groups.h"

#include "common/simt/groups/reduce.h"
