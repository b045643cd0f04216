# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Completion for bash: options, and what belongs to each, as `sbox-merge --help` tells them.
_sbox_merge() {
  local command=$1 word=${COMP_WORDS[COMP_CWORD]} line name owner="" i
  local -A kind=() many=()
  while IFS= read -r line; do
    if [[ $line =~ ^\ +(-[a-zA-Z],\ *)?(--[a-z-]+)(\ ([^ ]+))?(\ (\.\.\.))? ]]; then
      name=${BASH_REMATCH[2]}
      kind[$name]=${BASH_REMATCH[4]}
      many[$name]=${BASH_REMATCH[6]}
    fi
  done < <("$command" --help 2> /dev/null)

  # The option that the word belongs to: the one before it, or further back one that takes several.
  for ((i = COMP_CWORD - 1; i > 0; i--)); do
    name=${COMP_WORDS[i]}
    if [[ $name == -* ]]; then
      if ((i == COMP_CWORD - 1)) || [[ -n ${many[$name]-} ]]; then
        owner=$name
      fi
      break
    fi
  done

  COMPREPLY=()
  if [[ $word == -* || -z $owner || -z ${kind[$owner]-} ]]; then
    mapfile -t COMPREPLY < <(compgen -W "${!kind[*]}" -- "$word" | sort)
    return
  fi
  case ${kind[$owner]} in
    DIR)
      compopt -o filenames 2> /dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "$word")
      ;;
    FILE* | MAP)
      compopt -o filenames 2> /dev/null
      mapfile -t COMPREPLY < <(compgen -f -- "$word")
      ;;
    *[a-z]*)
      mapfile -t COMPREPLY < <(compgen -W "${kind[$owner]//|/ }" -- "$word")
      ;;
  esac
}
complete -F _sbox_merge sbox-merge
