"""Writes a valid specification of about so many lines: skills of some 250 lines, each in a file of its own with a file of
modules beside it, all over one file of messages and devices. The same seed gives the same bytes."""
import pathlib
import random

SENSORS = 3

SHARED = """# What all skills share: their devices, and the messages of the robot.
DEVICE alter "the robot controller's port: asks for a motion, takes it"
MESSAGE motion     : dx, dy, dz : REAL mm; rx, ry, rz : REAL deg
MESSAGE correction : dx, dy, dz : REAL mm; rx, ry, rz : REAL deg
MESSAGE tick       : SIGNAL
""" + "".join(f"""DEVICE sensor-{i} "a sensor of the cell"
MESSAGE raw-{i}    : fx, fy, fz : REAL N; tx, ty, tz : REAL N*m
MESSAGE force-{i}  : REAL N
""" for i in range(1, SENSORS + 1))

SENSOR_MODULES = """
Sensor Driver: SD{i}
BEGIN
  REPEAT
    WTM( request raw-{i} from LS{i} )
    TXM( request raw-{i} from sensor-{i} )
    WTM( raw-{i} from sensor-{i} )
    TXM( raw-{i} to LS{i} )
  UNTIL( forever )
END

# The part of the raw data that the skill asks for.
Logical Sensor: LS{i}
  ACTIVITY extract READS raw-{i} WRITES force-{i}
BEGIN
  REPEAT
    WTM( request force-{i} from SM1 )
    TXM( request raw-{i} from SD{i} )
    WTM( raw-{i} from SD{i} )
    extract
    TXM( force-{i} to SM1 )
  UNTIL( forever )
END
"""

MOTION_MODULES = """
Machine Controller: MC1
  ACTIVITY obey READS motion WRITES correction
  ACTIVITY hold              WRITES correction
BEGIN
  REPEAT
    WTM( tick from alter )
    TXM( request motion from SM1 )
    WTM( motion from SM1 ) WITHIN 4 ms
      obey
    ELSE
      hold
    END WTM
    TXM( correction to alter )
  UNTIL( forever )
END

Contingency Module: CM1
  ACTIVITY retreat WRITES motion
BEGIN
  REPEAT
    WTM( motion request from MC1 )
    retreat
    TXM( motion to MC1 )
    SPC( home )
  UNTIL( home )
END
"""


class Skill:
    def __init__(self, number, rng):
        self.number = number
        self.rng = rng

    def modules(self):
        text = f'# The modules of skill-{self.number}.\nUSES "shared.pal"\n\n'
        for i in range(1, SENSORS + 1):
            text += f'CONDITION near-{i} FROM force-{i} "sensor {i} feels something"\n'
        text += 'CONDITION reached "far enough"\nCONDITION home "back where the skill began"\n'
        for i in range(1, SENSORS + 1):
            text += SENSOR_MODULES.format(i=i)
        return text + MOTION_MODULES

    def main(self):
        sensors = ", ".join(f"SD{i}" for i in range(1, SENSORS + 1))
        logical = ", ".join(f"LS{i}" for i in range(1, SENSORS + 1))
        phases = "".join(self.phase() for _ in range(self.rng.randint(7, 10)))
        return f'''USES "modules_{self.number}.pal"

SKILL skill-{self.number}
  DESCRIPTION   "Moves in phases, each of which listens to a sensor."
  PRECONDITION  "The way is free."
  POSTCONDITION "The tool stands still."
  SENSOR DRIVER      {sensors}
  LOGICAL SENSOR     {logical}
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  CONTINGENCY 1 "Nothing was met." METHOD CM1
  PARAMETER speed : REAL mm/s DEFAULT {self.rng.randint(2, 50)} RANGE 1 TO 60 "speed along the tool's axis"
  COMPLETION 0 NORMAL        "done"
  COMPLETION 1 CONTINGENCY 1 "not done"
  COMPLETION 2 ERROR         "failed"
END SKILL

Skill Module: SM1
  ACTIVITY advance WRITES motion
  ACTIVITY stop    WRITES motion
BEGIN
  WTM( Coordinator )
{self.sense_all()}{phases}{self.approach()}
  CASE
    ( reached = FALSE ):
      WTM( motion request from MC1 )
      TXM( Completion Protocol 0 )
    ( reached = TRUE ):
      Execute CM1
      TXM( Completion Protocol 1 )
  END CASE
END
'''

    def sensor(self):
        return self.rng.randint(1, SENSORS)

    @staticmethod
    def sense(i, indent="  "):
        return (f"{indent}TXM( request force-{i} from LS{i} )\n{indent}WTM( force-{i} from LS{i} )\n"
                f"{indent}SPC( near-{i} )\n")

    def sense_all(self):
        return "".join(self.sense(i) for i in range(1, SENSORS + 1)) + "  SPC( reached = FALSE )\n"

    def phase(self):
        return "\n" + self.rng.choice([self.move, self.listen, self.choose, self.first_of_two])()

    def move(self):
        i = self.sensor()
        return (f"  # The sensor, then one motion.\n{self.sense(i)}  WTM( motion request from MC1 )\n  RPC( near-{i} )\n  CASE\n"
                f"    ( near-{i} = TRUE ):\n      stop\n      TXM( motion to machine controller MC1 )\n"
                f"    ( near-{i} = FALSE ):\n      advance\n      TXM( motion to machine controller MC1 )\n"
                f"      SPC( reached )\n  END CASE\n")

    def listen(self):
        i = self.sensor()
        return f"  REPEAT\n{self.sense(i, '    ')}  UNTIL( near-{i} OR reached )\n"

    def choose(self):
        i, k = self.rng.sample(range(1, SENSORS + 1), 2)
        return (f"{self.sense(i)}{self.sense(k)}  CASE\n    ( near-{i} AND NOT near-{k} ):\n{self.sense(k, '      ')}"
                f"    ( near-{i} AND near-{k} ):\n      Do Nothing\n"
                f"    ( NOT near-{i} ):\n{self.sense(i, '      ')}  END CASE\n")

    def first_of_two(self):
        i, k = self.rng.sample(range(1, SENSORS + 1), 2)
        text = f"  TXM( request force-{i} from LS{i} )\n  TXM( request force-{k} from LS{k} )\n  WTM FIRST\n"
        for a, b in ((i, k), (k, i)):
            text += (f"    ( force-{a} from LS{a} ):\n      SPC( near-{a} )\n      WTM( force-{b} from LS{b} )\n"
                     f"      SPC( near-{b} )\n")
        return text + "  END WTM\n"

    def approach(self):
        i = self.sensor()
        return f'''
  CONCURRENT
  BEGIN
    REPEAT
{self.sense(i, '      ')}    UNTIL( forever )
  END
  BEGIN
    REPEAT
      WTM( motion request from MC1 )
      RPC( near-{i} )
      CASE
        ( near-{i} = TRUE ):
          stop
          TXM( motion to machine controller MC1 )
        ( near-{i} = FALSE ):
          advance
          TXM( motion to machine controller MC1 )
          SPC( reached )
      END CASE
    UNTIL( near-{i} OR reached )
  END
  END CONCURRENT
'''


def write(folder, lines, seed=20261121):
    """Files in `folder` with `lines` lines or a skill more; gives the file that uses them all, and the number."""
    folder = pathlib.Path(folder)
    rng = random.Random(seed)
    (folder / "shared.pal").write_text(SHARED)
    written = SHARED.count("\n")
    skills = 0
    while written < lines:
        skills += 1
        skill = Skill(skills, rng)
        for name, text in ((f"modules_{skills}.pal", skill.modules()), (f"skill_{skills}.pal", skill.main())):
            (folder / name).write_text(text)
            written += text.count("\n")
    return [str(folder / f"skill_{i}.pal") for i in range(1, skills + 1)], written
