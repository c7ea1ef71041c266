"""The tree keeps the rules of resources/help/architecture.md:   python3 check_house.py ROOT [RULE...]"""
import sys

import rules_data
import rules_house
import rules_source
from tree import read_tree

RULES = rules_house.RULES | rules_source.RULES | rules_data.RULES


def main():
    files = read_tree(sys.argv[1])
    if not any(path.startswith("control/") for path in files):
        sys.exit(f"{sys.argv[1]} is not the source tree")
    found = [(name, *violation) for name in sys.argv[2:] or RULES for violation in RULES[name](files)]
    for name, path, line, message in found:
        print(f"{path}:{line}: {message} [{name}]")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
