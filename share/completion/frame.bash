
_PROGRAM_words() { COMPREPLY=($(compgen -W "$1" -- "$cur")); }

_PROGRAM_file() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$cur")
}

_PROGRAM_folder() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$cur")
}

# A machine by its name, or a file.
_PROGRAM_machine() {
    _PROGRAM_file
    COMPREPLY+=($(compgen -W "$("${COMP_WORDS[0]}" --machines 2>/dev/null)" -- "$cur"))
}

_PROGRAM() {
    local cur=${COMP_WORDS[COMP_CWORD]} command=PROGRAM option= i given
    local parent takes words options values
    COMPREPLY=()
    _PROGRAM_facts "$command"
    for ((i = 1; i < COMP_CWORD; i++)); do
        given=${COMP_WORDS[i]}
        if [[ $given == = ]]; then
            : # between an option and its value
        elif [[ $option ]]; then
            option= # this is its value
        elif [[ $given == -* ]]; then
            [[ " $values " == *" $given "* ]] && option=$given
        elif [[ $parent ]]; then
            command="$command $given"
            _PROGRAM_facts "$command"
        elif [[ $takes == program ]]; then
            _PROGRAM_file # what follows is the program's
            return
        fi
    done
    [[ $cur == = ]] && cur=
    if [[ $option ]]; then
        _PROGRAM_value "$command" "$option"
    elif [[ $cur == -* ]]; then
        _PROGRAM_words "$options"
        _PROGRAM_more
    else
        case $takes in
        machine) _PROGRAM_machine ;;
        ?*) _PROGRAM_file ;;
        esac
        COMPREPLY+=($(compgen -W "$words" -- "$cur"))
    fi
}
