#include "control/base/matrix_blocks.h"

#include <gmock/gmock.h>

/// Starts every test program as the workstation starts: a result computed here must be the same byte for byte
/// as one that the program itself computes on this machine.
int main(int count, char** words) {
    halbench::fixMatrixBlocks();
    testing::InitGoogleMock(&count, words);
    return RUN_ALL_TESTS();
}
