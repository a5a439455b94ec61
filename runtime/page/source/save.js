// Files that the page gives to the person in front of it.

/** Saves what `address` (of data or of a blob) holds under `name`. */
export function save_as(name, address) {
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
}

export function save_text(name, type, text) {
  const address = URL.createObjectURL(new Blob([text], {type}));
  save_as(name, address);
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}
