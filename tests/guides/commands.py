"""The ./raylab commands that pages show: command and options exist, what they name is there."""
import functools
import json
import pathlib
import re
import shlex
import subprocess

from pages import page, pages_of

HERE = pathlib.Path(__file__).resolve().parent
CALL = re.compile(r"((?:\b[A-Z_]+=\S+ +)*)\./raylab\b(?!/)([^&|;'>\n]*)")
PLACEHOLDER = re.compile(r"[A-Z][A-Z_]+(\.\w+)?|N\.M|\.\.\.|\[.*\]")
WRITES = {"-o", "--output", "--stats", "--lanes", "--write", "--keep", "--snapshots"}
READS = {"--with", "--reference"}
NOT_FOR_STUDENTS = {"doctor", "grade", "grade-class", "prove", "release", "test"}  # do not work in their trees


class Help:
    """options: name -> (takes values: 0, 1 or many, choices); positionals: their names."""

    def __init__(self, text):
        self.text, self.options, self.positionals, self.repeats = text, {}, [], False
        for line in text.splitlines():
            option = re.match(r"  (-[-\w,]+)(?: (\S+)(.*)| {2,}.*)?$", line)
            if option:
                takes = 1 if option[2] and option[2] not in ("Excludes:", "Needs:") else 0
                many = takes and re.match(r"( REQUIRED)? \.\.\.", option[3])
                choices = re.search(r"\{([^}]*)\}", option[2] or "")
                for name in option[1].split(","):
                    self.options[name] = (2 if many else takes, choices[1].split(",") if choices else None)
        section = re.search(r"^Positionals:\n((?:  .*\n)+)", text, re.MULTILINE)
        if section:
            self.positionals = re.findall(r"^  (\w+) .*$", section[1], re.MULTILINE)
            self.repeats = bool(re.search(r"^  \w+ TEXT(?::\S+)? \.\.\.", section[1], re.MULTILINE))


class Commands:
    """programs: the built raylab, raylab-check, raylab-run and others, which know their commands."""

    def __init__(self, programs):
        self.programs = programs

    @functools.lru_cache(maxsize=None)
    def help_of(self, tree, command):
        """None: there is no such command."""
        script = (tree / "raylab").read_text()
        if command == "test":
            return Help(re.search(r"cat <<'HELP'\n(\./raylab test.*?)\nHELP", script, re.DOTALL)[1])
        if (tree / "cmake" / f"{command}.sh").is_file() and re.search(rf"^    {command}\) ", script, re.MULTILINE):
            call = [tree / "cmake" / f"{command}.sh", "--help"]
            return Help(subprocess.run(call, capture_output=True, text=True, check=True).stdout)
        for program in self.programs:
            run = subprocess.run([program, command, "--help"], capture_output=True, text=True)
            if run.returncode == 0 and "Usage: raylab " + command in run.stdout:
                return Help(run.stdout)
        return None


class Tree:
    def __init__(self, root, released):
        self.root, self.released = root, released
        self.labs, self.tasks = set(), set()
        for sheet in root.glob("labs/*/lab.json"):
            lab = json.loads(sheet.read_text())
            self.labs |= {lab["number"], lab["folder"]}
            self.tasks |= {task["id"] for task in lab["tasks"]}
        self.scenes = {scene.stem for scene in root.glob("scenes/*.json")} - {"scene.schema"}
        presets = json.loads((root / "CMakePresets.json").read_text())
        self.presets = {preset["name"] for preset in presets["configurePresets"]}
        own = (HERE / "readers_files.txt").read_text().splitlines()
        self.readers_files = {line.split("#")[0].strip() for line in own} - {""}


def wrong_with(words, tree, commands, written):
    """What is wrong with ./raylab's arguments; written: files that commands of the page write."""
    if not words or words[0] in ("--help", "-h") or PLACEHOLDER.fullmatch(words[0]):
        return
    command, words = words[0], words[1:]
    if tree.released and command in NOT_FOR_STUDENTS:
        yield f"{command} does not work in this tree"
        return
    described = commands.help_of(tree.root, command)
    if described is None:
        yield f"there is no command {command}"
        return
    given = []
    while words:
        word = words.pop(0)
        if word == "--":
            break
        if not word.startswith("-"):
            given.append(word)
            continue
        name, equals, value = word.partition("=")
        if name in ("-h", "--help"):
            continue
        if name not in described.options and not re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", described.text):
            yield f"{command} has no option {name}"
            continue
        takes, choices = described.options.get(name, (0, None))
        values = [value] if equals else []
        while takes and words and not words[0].startswith("-") and (takes == 2 or not values):
            values.append(words.pop(0))
        if takes and not values:
            yield f"{name} wants a value"
        for value in values:
            yield from wrong_value(command, name, value, choices, tree, written)
    if described.positionals or command not in ("test", "vendor", "site"):
        yield from wrong_positionals(command, described, given, tree, written)


def wrong_value(command, name, value, choices, tree, written):
    if PLACEHOLDER.fullmatch(value):
        return
    if choices and not set(value.split(",")) <= set(choices) and not value[0].isdigit():
        yield f"{name} {value}: there are {', '.join(choices)}"
    if name in ("--labs", "--lab"):
        for lab in value.split(","):
            if lab not in tree.labs:
                yield f"this tree has no lab {lab}"
    if name in READS:
        yield from missing_file(value, tree, written)


def missing_file(name, tree, written):
    if not (PLACEHOLDER.fullmatch(name) or name in written or name in tree.readers_files
            or (tree.root / name).exists()):
        yield f"{name} is not there, and no command of this page writes it"


def wrong_positionals(command, described, given, tree, written):
    kinds = list(described.positionals)
    if len(given) > len(kinds) and not (kinds and described.repeats):
        yield f"{command} takes {len(kinds)} arguments: {' '.join(given)}"
        return
    while len(kinds) < len(given):
        kinds.append(kinds[-1])
    for kind, word in zip(kinds, given):
        if PLACEHOLDER.fullmatch(word):
            continue
        if kind in ("LAB", "LABS"):
            if word not in tree.labs:
                yield f"this tree has no lab {word}"
        elif kind == "TASK":
            if word not in tree.tasks:
                yield f"this tree has no task {word}"
        elif kind in ("SCENE", "SCENES"):
            if word.split(":")[0] not in tree.scenes and not word.split(":")[0].isalpha():
                yield from missing_file(word, tree, written)
            elif word.split(":")[0] not in tree.scenes:
                yield f"there is no scene {word}"
        elif kind in ("FILE", "FILES", "IMAGES"):
            yield from missing_file(word, tree, written)


def words_of(text):
    text = re.sub(r"\s{2,}.*", "", text.strip())  # a remark in a column of its own
    return shlex.split(text.strip(" .,)"))


def calls_in(page_path):
    """(line, settings, words) of each ./raylab of the page."""
    for line, text in page(page_path).code:
        for call in CALL.finditer(re.sub(r"(^|\s)#.*|\\$", "", text)):
            try:
                yield line, call[1].split(), words_of(call[2])
            except ValueError:
                yield line, [], ["a quotation that does not end"]


def files_written(calls):
    for _, _, words in calls:
        for option, value in zip(words, words[1:]):
            if option in WRITES:
                yield value.split(":")[-1]


def false_commands(root, released, commands):
    tree = Tree(root, released)
    count = 0
    for name in pages_of(root):
        if "measurements" in name.parts:  # what was done on that day
            continue
        calls = list(calls_in(root / name))
        count += len(calls)
        written = set(files_written(calls))
        for line, settings, words in calls:
            for setting in settings:
                key, _, value = setting.partition("=")
                if key == "RAYLAB_PRESET" and value not in tree.presets:
                    yield f"{name}:{line}: there is no preset {value}"
            for wrong in wrong_with(list(words), tree, commands, written):
                yield f"{name}:{line}: ./raylab {' '.join(words)}: {wrong}"
        for line, text in page(root / name).code:
            for script in re.findall(r"\bpython3 ((?:tools|tests)/\S+\.py)", text):
                if not (root / script).is_file():
                    yield f"{name}:{line}: {script} is not there"
    if count == 0:
        yield "no command was found"
