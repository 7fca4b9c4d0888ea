// Modules with a CONCURRENT that blocks execute, worked out by hand from docs/execution-model.md.
#include "tests/attack/by_hand.hpp"

using namespace pal;
using pal::test::bound;
using pal::test::cell;

TEST_CASE("two blocks that execute a module at a time have its blocks for themselves") {
  // The first has short until 1 ms, then the second its rest until 2; its work is done elsewhere than the
  // first's, which lasts until 3.
  CHECK(bound(cell("AGE OF c AT done IN SM1", R"(Machine Controller: MC1
Contingency Module: CM1
  ACTIVITY work
  ACTIVITY short
BEGIN
  CONCURRENT
  BEGIN
    work
  END
  BEGIN
    short
  END
  END CONCURRENT
END
Skill Module: SM1
  ACTIVITY rest
  ACTIVITY done
BEGIN
  WTM( Coordinator )
  RPC( c )
  CONCURRENT
  BEGIN
    Execute CM1
  END
  BEGIN
    rest
    CM1
  END
  END CONCURRENT
  done
  TXM( motion to MC1 )
  TXM( Completion Protocol 0 )
END
)",
                   "  PROCESSOR P\n  PROCESSOR Q\n  PROCESSOR R\n  PLACE SM1 ON P PRIORITY 1\n"
                   "  PLACE CM1.1 ON Q PRIORITY 1\n  PLACE SM1.2/CM1.1 ON R PRIORITY 1\n"
                   "  TIME work : 3 ms\n  TIME short : 1 ms\n  TIME rest : 1 ms\n  TIME done : 0 ms\n"
                   "  DEVICE MC1 ON REQUEST 1 ms\n")) == 5);
}

TEST_CASE("what the blocks of an executed module have open is taken back with the block that executes it") {
  // MC2.1 asks at 0 and ends at 1, the block that executes MC2 is stopped at 2: the answer of 5 ms is
  // discarded, and the next request answered at 10.
  CHECK(bound(cell("AGE OF c AT obey IN MC1", R"(Machine Controller: MC1
  ACTIVITY obey
  ACTIVITY rest
BEGIN
  RPC( c )
  CONCURRENT
  BEGIN
    REPEAT
      Execute MC2
    UNTIL( forever )
  END
  BEGIN
    rest
  END
  END CONCURRENT
  TXM( request motion from SM1 )
  WTM( motion from SM1 )
  obey
END
Machine Controller: MC2
  ACTIVITY hold
BEGIN
  CONCURRENT
  BEGIN
    TXM( request motion from SM1 )
    hold
  END
  BEGIN
    hold
    hold
    hold
  END
  END CONCURRENT
END
Skill Module: SM1
  ACTIVITY think
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( request motion from MC1 )
    think
    TXM( motion to MC1 )
  UNTIL( forever )
END
)",
                   "  PROCESSOR P\n  PROCESSOR Q\n  PROCESSOR R\n  PLACE SM1 ON Q PRIORITY 1\n"
                   "  PLACE MC1 ON P PRIORITY 1\n  PLACE MC1.2 ON R PRIORITY 1\n"
                   "  TIME think : 5 ms\n  TIME obey : 0 ms\n  TIME hold : 1 ms\n  TIME rest : 2 ms\n")) ==
        10);
}

TEST_CASE("a block of an executed module that has none of its own runs where the module does") {
  // CM1.2 stands in CM1.1, which has a place; it runs where SM1.1 does, and waits there for SM1.2.
  CHECK(bound(cell(
            "AGE OF c AT done IN SM1", R"(Machine Controller: MC1
Contingency Module: CM1
  ACTIVITY work
BEGIN
  CONCURRENT
  BEGIN
    CONCURRENT
    BEGIN
      work
    END
    END CONCURRENT
  END
  END CONCURRENT
END
Skill Module: SM1
  ACTIVITY rest
  ACTIVITY done
BEGIN
  WTM( Coordinator )
  RPC( c )
  CONCURRENT
  BEGIN
    CM1
  END
  BEGIN
    rest
  END
  END CONCURRENT
  done
  TXM( motion to MC1 )
  TXM( Completion Protocol 0 )
END
)",
            "  PROCESSOR P\n  PROCESSOR Q\n  PROCESSOR R\n  PLACE SM1 ON P PRIORITY 1\n"
            "  PLACE SM1.1 ON Q PRIORITY 1\n  PLACE SM1.2 ON Q PRIORITY 2\n  PLACE CM1.1 ON R PRIORITY 1\n"
            "  TIME work : 3 ms\n  TIME rest : 4 ms\n  TIME done : 0 ms\n"
            "  DEVICE MC1 ON REQUEST 1 ms\n")) == 7);
}
