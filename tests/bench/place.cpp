// Shifts what is linked behind it by some bytes.
asm(".text\n.skip " TREELINE_BENCH_PLACE "\n");
