#pragma once

namespace halbench {

/// The sizes of the blocks in which products of large matrices are summed, the same on every machine. By
/// default Eigen takes them from the caches of the processor, and another cut sums in another order: the last
/// digits of a result would be those of the machine. Every program calls it first: the workstation and the
/// tests.
void fixMatrixBlocks();

} // namespace halbench
