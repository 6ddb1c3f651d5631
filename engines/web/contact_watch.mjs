export class ContactWatch { }
