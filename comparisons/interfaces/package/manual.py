"""manual.py PROGRAM FOLDER: writes the manual page and what bash, zsh and fish complete, made of the program's own help."""
import re
import shlex
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

KINDS = ("scenes", "suites", "ensembles", "cylinders", "lessons", "engines")  # of `rockstack list`


@dataclass
class Argument:
    """A line of help: an option with its names, or what stands by itself."""

    names: list[str]
    value: str  # as help has it: "", "TEXT", "TEXT:{taylor,rk4}=taylor", …
    text: str
    choices: list[str] = field(default_factory=list)
    kinds: list[str] = field(default_factory=list)  # whose names it may be

    def __post_init__(self):
        if braces := re.search(r"\{(.*?)\}", self.value):
            self.choices = braces[1].split(",")
        told = self.names[-1] if self.names[0].startswith("-") else self.text
        self.kinds = [kind for kind in KINDS if not self.choices and re.search(rf"\b{kind[:-1]}s?\b", told)]


@dataclass
class Command:
    name: str
    text: str
    sections: dict[str, list[Argument]]

    @property
    def options(self):
        return self.sections.get("Options", []) + self.sections.get("Common options", [])

    @property
    def positionals(self):
        return self.sections.get("Positionals", [])


def sections_of(text):
    """The lines of help under each heading."""
    sections, current = {}, None
    for line in text.splitlines():
        if heading := re.fullmatch(r"(\w[\w ]*):", line):
            current = sections.setdefault(heading[1], [])
        elif current is not None and (entry := re.fullmatch(r"  (\S+(?: \S+)*)(?: {2,}(.*))?", line)):
            head = entry[1].split(" ", 1)
            current.append(Argument(head[0].split(","), *head[1:] or [""], entry[2] or ""))
        elif current and line.strip():
            current[-1] = Argument(current[-1].names, current[-1].value, line.strip())
    return sections


def commands_of(program):
    def help_of(*words):
        return sections_of(subprocess.run([program, *words, "--help"], check=True, capture_output=True, text=True).stdout)

    main = help_of()
    commands = [Command(one.names[0], " ".join([one.value, one.text]).strip(), help_of(one.names[0])) for one in main["Subcommands"]]
    return Command("rockstack", "", main), commands


def roff(text):
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"))


def entries(arguments):
    def head(one):
        return ", ".join(f"\\fB{roff(name)}\\fR" for name in one.names)

    return "".join(f".TP\n{head(one)} {roff(one.value)}\n{roff(one.text)}\n" for one in arguments)


def manual(version, main, commands):
    page = f'.TH ROCKSTACK 1 "" "{version}" "User Commands"\n'
    page += ".SH NAME\nrockstack \\- exact motions of stacked rocking blocks, beside physics engines\n"
    page += ".SH SYNOPSIS\n.B rockstack\n.I command\n[\\fIoptions\\fR] \\fIarguments\\fR\n.SH COMMANDS\n"
    for command in commands:
        words = " ".join(f"\\fI{roff(one.names[0])}\\fR" for one in command.positionals)
        page += f".SS rockstack {roff(command.name)} {words}\n{roff(command.text)}\n"
        page += entries([*command.positionals, *command.sections["Options"][1:]])
    page += ".SH OPTIONS\n" + entries(main.options)
    page += (".SH EXIT STATUS\n.TP\n0\nAll is done.\n.TP\n1\nSomething failed, or of \\fBrockstack diff\\fR or \\fBrockstack gate\\fR got worse.\n"
             ".TP\n2\nWhat was given is wrong; one line says what, where, and what is allowed.\n"
             ".TP\n3\nOf \\fBrockstack diff\\fR nothing is shown to be worse, but there are rows of which nothing can be said.\n"
             ".SH ENVIRONMENT\n.TP\nROCKSTACK_WORKERS\nFolders of more engines, with colons between them.\n")
    return page


def listed(kinds, end=" "):
    """What a shell runs to get the names of some kinds."""
    return "; ".join(f"rockstack list {kind} 2>/dev/null | cut -d{shlex.quote(end)} -f1" for kind in kinds)


def bash(_, main, commands):
    def candidates(one):
        return f"$({listed(one.kinds)})" if one.kinds else " ".join(one.choices)

    def files(one):
        return "" if one.choices else "; COMPREPLY=($(compgen -f -- \"$word\"))"

    text = "_rockstack() {\n  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words=\n"
    text += "  case ${COMP_WORDS[1]}:$before in\n"
    for command in commands:
        for one in command.options:
            if one.value:
                names = "|".join(f"{command.name}:{name}" for name in one.names)
                text += f"    {names}) words=\"{candidates(one)}\"{files(one)} ;;\n"
    text += "    *)\n      case ${COMP_WORDS[1]}:$COMP_CWORD:$word in\n"
    text += f"        *:1:*) words='{' '.join([one.name for one in commands] + [one.names[-1] for one in main.options])}' ;;\n"
    for command in commands:
        options = " ".join(one.names[-1] for one in command.options)
        text += f"        {command.name}:*:-*) words='{options}' ;;\n"
        if command.positionals:
            first = command.positionals[0]
            text += f"        {command.name}:*) words=\"{candidates(first)}\"{files(first)} ;;\n"
    text += "      esac ;;\n  esac\n  COMPREPLY+=($(compgen -W \"$words\" -- \"$word\"))\n}\n"
    return text + "complete -o filenames -F _rockstack rockstack\n"


def zsh(_, main, commands):
    def quoted(text):
        return re.sub(r"([\[\]:\\])", r"\\\1", text)

    def action(one):
        if one.kinds:
            return f"{{ compadd -- $({listed(one.kinds)}); _files }}"
        return f"({' '.join(one.choices)})" if one.choices else "_files"

    def option(one):
        return [shlex.quote(("*" if "..." in one.value else "") + f"{name}[{quoted(one.text)}]" +
                            (f":{quoted(name)}:{action(one)}" if one.value else "")) for name in one.names]

    text = "#compdef rockstack\n_rockstack() {\n  local state line\n  local -a commands=(\n"
    text += "".join(f"    {shlex.quote(quoted(one.name) + ':' + quoted(one.text))}\n" for one in commands) + "  )\n"
    text += f"  _arguments -C {' '.join(word for one in main.options for word in option(one))} '1:command:->command' '*::argument:->arguments'\n"
    text += "  case $state in\n    command) _describe command commands ;;\n    arguments)\n      case $line[1] in\n"
    for command in commands:
        words = [word for one in command.options for word in option(one)]
        words += [shlex.quote(f"{'*' if '...' in one.value else ''}:{one.names[0]}:{action(one)}") for one in command.positionals]
        text += f"        {command.name}) _arguments {' '.join(words)} ;;\n"
    return text + "      esac ;;\n  esac\n}\n_rockstack \"$@\"\n"


def fish(_, main, commands):
    def candidates(one):
        wanted = f"({listed(one.kinds)})" if one.kinds else " ".join(one.choices)
        return f" -a {shlex.quote(wanted)}" if wanted else ""

    def option(one, condition):
        words = "".join(f" -l {name[2:]}" if name.startswith("--") else f" -s {name[1:]}" for name in one.names)
        needs = (" -x" if one.choices else " -r") if one.value else ""
        return f"complete -c rockstack -n {condition}{words}{needs} -d {shlex.quote(one.text)}{candidates(one)}\n"

    text = "".join(option(one, "__fish_use_subcommand") for one in main.options)
    for command in commands:
        seen = f"'__fish_seen_subcommand_from {command.name}'"
        text += f"complete -c rockstack -n __fish_use_subcommand -f -a {command.name} -d {shlex.quote(command.text)}\n"
        text += "".join(option(one, seen) for one in command.options)
        text += "".join(f"complete -c rockstack -n {seen}{' -f' if one.choices else ''}{candidates(one)} -d {one.names[0]}\n" for one in command.positionals)
    return text


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    version = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout.strip()
    told = commands_of(program)
    for name, write in (("rockstack.1", manual), ("rockstack", bash), ("_rockstack", zsh), ("rockstack.fish", fish)):
        (folder / name).write_text(write(version, *told), encoding="utf-8")


if __name__ == "__main__":
    main()
